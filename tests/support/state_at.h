#pragma once

#include "core/vehicle/uav_state.h"

namespace citrine {

/// Level, looking along x.
inline UavState StateAt(Utime utime, const Eigen::Vector3d& p_W) {
  UavState state;
  state.utime = utime;
  state.X_WB.p = p_W;
  return state;
}

}  // namespace citrine

#pragma once

#include <Eigen/Core>

#include "core/geometry/pose.h"
#include "core/time.h"

namespace citrine {

/// Where one UAV is and how it moves. Frames: W world, B body (x forward, z up).
struct UavState {
  Utime utime = 0;
  Pose X_WB;
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();      ///< [m/s]
  Eigen::Vector3d omega_B = Eigen::Vector3d::Zero();  ///< [rad/s]
  int contacts = 0;                                   ///< collisions since the mission began
};

}  // namespace citrine

#pragma once

#include <deque>
#include <map>
#include <vector>

#include "core/vehicle/uav_state.h"

namespace citrine {

/// Where each UAV was in the last second.
class FleetPositions {
 public:
  void Hear(int uav, const UavState& state);
  /// [m] positions of all UAVs but one at a time: the nearest state that is known, moved on by its velocity.
  std::vector<Eigen::Vector3d> Others(int uav, Utime time) const;

 private:
  std::map<int, std::deque<UavState>> states_;
};

}  // namespace citrine

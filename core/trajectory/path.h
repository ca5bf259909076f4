#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/vehicle/vehicle_limits.h"

namespace citrine {

struct Waypoint {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< [m]
  double free_radius_m = 0;                       ///< clearance to everything occupied or unknown
};

/// The way to a chosen view, as the planner says it: straight legs through known free space.
struct Path {
  std::int64_t id = 0;              ///< counts up per UAV; a hearer ignores an id that it knows
  std::vector<Waypoint> waypoints;  ///< from the UAV to the goal; empty means: stop where you are
  double goal_yaw_rad = 0;
  bool ends_at_goal = true;  ///< false where the way was clamped to the known free space
  VehicleLimits limits;
};

}  // namespace citrine

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

/// [m] a view counts as reached, or as passed, within it (design, section 6).
inline constexpr double kReached_m = 0.25;

/// The way to a chosen view, as the planner says it: straight legs through known free space.
///
/// Where the goal of the path before is one of the inner waypoints, the UAV still has to look from there: it
/// is flown through, within kReached_m, without a stop.
struct Path {
  std::int64_t id = 0;              ///< counts up per UAV; a hearer ignores an id that it knows
  std::vector<Waypoint> waypoints;  ///< from the UAV to the goal; empty means: stop where you are
  double goal_yaw_rad = 0;
  bool ends_at_goal = true;  ///< false where the way was clamped to the known free space
  VehicleLimits limits;
};

}  // namespace citrine

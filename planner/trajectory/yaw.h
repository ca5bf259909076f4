#pragma once

#include <vector>

#include "core/trajectory/trajectory.h"

namespace citrine::planner {

inline constexpr double kYawRateMax_radps = 1.5707963267948966;

/// Turns a motion smoothly from a yaw and rate to another yaw over its whole length, the short way round. If
/// there is not enough time for it at 90 degrees a second, it turns as far as there is.
void AddYaw(double yaw_rad, double yaw_rate_radps, double goal_yaw_rad,
            std::vector<TrajectorySegment>* segments);

}  // namespace citrine::planner

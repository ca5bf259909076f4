#pragma once

#include <algorithm>
#include <cmath>

#include "core/trajectory/trajectory.h"

namespace citrine::sim {

/// A straight minimum-jerk flight from rest to rest that reaches the larger of the two limits' durations: its
/// peak speed is 1.875 L / T and its peak acceleration 5.774 L / T^2.
inline Trajectory Dash(const Eigen::Vector3d& from_W, const Eigen::Vector3d& to_W, double speed_mps,
                       double acceleration_mps2, Utime start, double yaw_rad = 0) {
  const double length = (to_W - from_W).norm();
  const double T =
      std::max(1.875 * length / speed_mps, std::sqrt(10 / std::sqrt(3.0) * length / acceleration_mps2));
  const Eigen::Vector3d way = to_W - from_W;
  Trajectory dash;
  dash.start = start;
  TrajectorySegment segment;
  segment.duration_s = T;
  segment.coefficients.col(0) << from_W, yaw_rad;
  segment.coefficients.col(3).head<3>() = 10 * way / std::pow(T, 3);
  segment.coefficients.col(4).head<3>() = -15 * way / std::pow(T, 4);
  segment.coefficients.col(5).head<3>() = 6 * way / std::pow(T, 5);
  dash.segments.push_back(segment);
  return dash;
}

}  // namespace citrine::sim

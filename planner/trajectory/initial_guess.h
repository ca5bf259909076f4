#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/vehicle/vehicle_limits.h"
#include "planner/trajectory/minimum_jerk_spline.h"

namespace citrine::planner {

/// Where a solve begins: points along a path at most `kPieceMax_m` apart, and durations of a speed ramp along
/// them.
struct InitialGuess {
  std::vector<Eigen::Vector3d> points_W;  ///< one more than durations; the first is the start
  std::vector<double> durations_s;
};

inline constexpr double kPieceMax_m = 2.0;

/// @param points_W the path's corners, beginning at start.p
InitialGuess GuessAlong(const std::vector<Eigen::Vector3d>& points_W, const Knot& start,
                        const VehicleLimits& limits);

}  // namespace citrine::planner

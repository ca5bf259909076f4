#pragma once

#include <cstddef>
#include <optional>
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
  std::optional<std::size_t> pass;  ///< index of the point that has to be passed
};

inline constexpr double kPieceMax_m = 2.0;

/// @param points_W the path's corners, beginning at start.p  @param pass_W one of them that is kept in any
/// case
InitialGuess GuessAlong(const std::vector<Eigen::Vector3d>& points_W, const Knot& start,
                        const VehicleLimits& limits, const std::optional<Eigen::Vector3d>& pass_W = {});

}  // namespace citrine::planner

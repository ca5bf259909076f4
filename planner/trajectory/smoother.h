#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/trajectory/path.h"
#include "planner/trajectory/flight_objective.h"

namespace citrine::planner {

/// A motion along a path: where it begins, through what it goes, where it comes to rest.
struct SmoothingTask {
  Knot start;  ///< left exactly so
  Utime begins = 0;
  std::vector<Eigen::Vector3d> points_W;  ///< the way, beginning at start.p; two at least
  std::optional<Eigen::Vector3d> pass_W;  ///< the inner one of them that is flown through within kReached_m
};

struct SmoothingResult {
  MinimumJerkSpline spline;
  double cost = 0;
  int evaluations = 0;
};

/// Turns the straight legs of a path into one smooth motion that ends at rest (paper, IV-E): NLopt's L-BFGS
/// over the inner points and the durations of a minimum-jerk spline. Stops by evaluations, never by time; the
/// same bits every time.
class Smoother {
 public:
  explicit Smoother(int evaluations_max) : evaluations_max_(evaluations_max) {}

  /// @param warm begin at this result instead of at the path's own guess, if not null
  SmoothingResult Solve(const FlightScene& scene, const FlightWeights& weights, const SmoothingTask& task,
                        const SmoothingResult* warm = nullptr) const;

 private:
  int evaluations_max_;
};

}  // namespace citrine::planner

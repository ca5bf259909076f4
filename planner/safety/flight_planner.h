#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/trajectory/path.h"
#include "planner/path/path_search.h"
#include "planner/trajectory/smoother.h"
#include "planner/trajectory/trajectory_check.h"

namespace citrine::planner {

/// Smoother::Solve, or what stands in for it: the wire measures it, tests make it fail.
using SolveMotion = std::function<SmoothingResult(const FlightScene&, const FlightWeights&,
                                                  const SmoothingTask&, const SmoothingResult* warm)>;

/// From a path to a checked trajectory, by a ladder: smooth the path, through the waypoint that is to be
/// passed; the same with what was violated
/// weighing more; smooth a way found anew around what stands there; and from a standing start, straight legs
/// from rest to rest.
class FlightPlanner {
 public:
  FlightPlanner(const PlanningMap& map, const VehicleLimits& limits, double path_margin_m,
                const FlightWeights& weights, SolveMotion solve);

  /// What is asked: leave `flown` at `at` and come to rest at the path's end.
  struct Task {
    const Trajectory& flown;
    Utime now = 0, at = 0;
    const Path& path;
    std::optional<Eigen::Vector3d> pass_W;  ///< one of its waypoints that is flown through within kReached_m
    const FlightScene& scene;
  };

  /// @param accept a last word on a trajectory that passed every check; may be null
  /// @return the trajectory from `now` on, `flown` until `at`; nullopt: there is none, `why` tells
  std::optional<Trajectory> Plan(const Task& task, const std::function<bool(const Trajectory&)>& accept,
                                 std::string* why);

 private:
  using Points = std::vector<Eigen::Vector3d>;

  /// The path's points from a start on, without those that need not be visited; empty: no point can be seen
  /// from there.
  Points Join(const Task& task, const Eigen::Vector3d& start_W) const;
  Points FindAnew(const Task& task, const Eigen::Vector3d& start_W);
  std::optional<Trajectory> Smooth(const Task& task, const Points& points_W, std::string* why) const;
  std::optional<Trajectory> FlyLegs(const Task& task, const Points& points_W, std::string* why) const;
  Trajectory Finish(const Task& task, std::vector<TrajectorySegment> segments) const;

  PathSearch search_;
  SafeSpace space_;
  FlightWeights weights_;
  SolveMotion solve_;
};

}  // namespace citrine::planner

#include "planner/safety/flight_planner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planner/trajectory/trajectory_cut.h"
#include "planner/trajectory/yaw.h"

namespace citrine::planner {

namespace {

constexpr int kSolvesMax = 3;
constexpr double kHeavier = 10;
constexpr double kShortest_m = 0.02;
constexpr double kStill = 1e-3;  ///< [m/s, m/s^2]
constexpr double kHoverRoom_m = 0.1;
// A rest-to-rest quintic's peak speed and acceleration, relative to L/T and L/T^2.
constexpr double kQuinticSpeed = 1.875, kQuinticAcceleration = 5.7735;

/// Teammates that stand still cannot make way: the search goes around them.
std::vector<Ball> Standing(const FlightScene& scene, Utime now) {
  std::vector<Ball> balls;
  for (const Teammate& teammate : scene.teammates)
    if (teammate.trajectory.end() <= now)
      balls.push_back({teammate.trajectory.At(now).p_W, scene.separation_m() + kHoverRoom_m});
  return balls;
}

void WeighMore(Violation::Kind violated, FlightWeights* weights) {
  switch (violated) {
    case Violation::Kind::kSpeed:
    case Violation::Kind::kAcceleration:
      weights->limits *= kHeavier;
      break;
    case Violation::Kind::kTeammate:
      weights->teammates *= kHeavier;
      break;
    default:
      weights->clearance *= kHeavier;
      break;
  }
}

}  // namespace

FlightPlanner::FlightPlanner(const PlanningMap& map, const VehicleLimits& limits, double path_margin_m,
                             const FlightWeights& weights, SolveMotion solve)
    : search_(map, limits, path_margin_m),
      space_(map, limits, 0),
      weights_(weights),
      solve_(std::move(solve)) {}

std::optional<Trajectory> FlightPlanner::Plan(const Task& task,
                                              const std::function<bool(const Trajectory&)>& accept,
                                              std::string* why) {
  const TrajectoryPoint start = task.flown.At(task.at);
  const auto accepted = [&](const std::optional<Trajectory>& found) {
    if (!found) return false;
    if (!accept || accept(*found)) return true;
    *why = "an obstacle in the newest scan";
    return false;
  };
  const Points joined = Join(task, start.p_W);
  std::optional<Trajectory> found;
  if (!joined.empty() && accepted(found = Smooth(task, joined, why))) return found;
  Points anew = FindAnew(task, start.p_W);
  if (anew == joined) anew.clear();  // what was tried
  if (!anew.empty() && accepted(found = Smooth(task, anew, why))) return found;
  const bool still = start.v_W.norm() < kStill && start.a_W.norm() < kStill;
  if (still && !joined.empty() && accepted(found = FlyLegs(task, joined, why))) return found;
  if (still && !anew.empty() && accepted(found = FlyLegs(task, anew, why))) return found;
  if (joined.empty() && anew.empty()) *why = "no way through known free space";
  return std::nullopt;
}

FlightPlanner::Points FlightPlanner::Join(const Task& task, const Eigen::Vector3d& start_W) const {
  const Path& path = task.path;
  std::size_t last = 0;  // that has to be visited
  while (last + 1 < path.waypoints.size() && path.waypoints[last].p_W != task.pass_W) ++last;
  for (std::size_t i = last + 1; i-- > 0;) {
    if (!space_.LegSafe(start_W, path.waypoints[i].p_W)) continue;
    Points points_W = {start_W};
    for (std::size_t k = i; k < path.waypoints.size(); ++k) points_W.push_back(path.waypoints[k].p_W);
    return points_W;
  }
  return {};
}

FlightPlanner::Points FlightPlanner::FindAnew(const Task& task, const Eigen::Vector3d& start_W) {
  const std::optional<Path> path =
      search_.Find(start_W, task.path.waypoints.back().p_W, Standing(task.scene, task.now));
  if (!path) return {};
  Points points_W;
  for (const Waypoint& waypoint : path->waypoints) points_W.push_back(waypoint.p_W);
  if ((points_W.front() - start_W).norm() > kShortest_m) points_W.insert(points_W.begin(), start_W);
  points_W.front() = start_W;
  return points_W;
}

std::optional<Trajectory> FlightPlanner::Smooth(const Task& task, const Points& points_W,
                                                std::string* why) const {
  const TrajectoryPoint start = task.flown.At(task.at);
  if (points_W.size() < 2) return std::nullopt;
  SmoothingTask smoothing{{start.p_W, start.v_W, start.a_W}, task.at, points_W, task.pass_W};
  if (points_W.size() == 2 && (points_W[1] - points_W[0]).norm() < kShortest_m && start.v_W.norm() < kStill)
    return std::nullopt;
  FlightWeights weights = weights_;
  std::optional<SmoothingResult> result;
  for (int solve = 0; solve < kSolvesMax; ++solve) {
    result = solve_(task.scene, weights, smoothing, result ? &*result : nullptr);
    Trajectory found = Finish(task, result->spline.Segments());
    const std::optional<Violation> violation = FindViolation(found, task.at, task.scene);
    if (!violation) return found;
    *why = violation->Reason();
    WeighMore(violation->kind, &weights);
  }
  return std::nullopt;
}

std::optional<Trajectory> FlightPlanner::FlyLegs(const Task& task, const Points& points_W,
                                                 std::string* why) const {
  std::vector<TrajectorySegment> legs;
  std::optional<Trajectory> furthest;
  for (std::size_t i = 0; i + 1 < points_W.size(); ++i) {
    const double length = (points_W[i + 1] - points_W[i]).norm();
    if (length < kShortest_m) continue;
    const VehicleLimits& limits = task.scene.limits;
    const double duration_s = std::max(
        kQuinticSpeed * length / (kPlannedSpeed * limits.speed_max_mps),
        std::sqrt(kQuinticAcceleration * length / (kPlannedAcceleration * limits.acceleration_max_mps2)));
    Knot from, to;
    from.p = legs.empty() ? task.flown.At(task.at).p_W : points_W[i];
    to.p = points_W[i + 1];
    legs.push_back(Quintic(from, to, duration_s));
    Trajectory found = Finish(task, legs);
    if (const std::optional<Violation> violation = FindViolation(found, task.at, task.scene)) {
      *why = violation->Reason();
      break;
    }
    furthest = std::move(found);
  }
  return furthest;
}

Trajectory FlightPlanner::Finish(const Task& task, std::vector<TrajectorySegment> segments) const {
  const TrajectoryPoint start = task.flown.At(task.at);
  AddYaw(start.yaw_rad, start.yaw_rate_radps, task.path.goal_yaw_rad, &segments);
  Trajectory found = Splice(task.flown, task.now, task.at, segments);
  found.path_id = task.path.id;
  return found;
}

}  // namespace citrine::planner

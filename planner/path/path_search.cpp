#include "planner/path/path_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace citrine::planner {

namespace {

constexpr double kGoalTolerance_m = 0.25;  ///< a view counts as reached within it (design, section 6)
constexpr double kShortest_m = 0.3;        ///< of a way towards a goal that cannot be reached
constexpr int kReachableMax = 100000;      ///< nodes looked at for a goal that is known to be connected
constexpr int kHopefulMax = 8000;          ///< and for one that may not be
constexpr std::uint32_t kUnit = LatticeSearch::kUnitCost;

bool InsideABall(const Eigen::Vector3d& p_W, const std::vector<Ball>& balls) {
  return std::any_of(balls.begin(), balls.end(), [&](const Ball& ball) {
    return (p_W - ball.p_W).squaredNorm() < ball.radius_m * ball.radius_m;
  });
}

/// Balls that a UAV already stands in keep only as much distance as there is.
std::vector<Ball> BallsAround(std::vector<Ball> balls, const Eigen::Vector3d& start_W) {
  for (Ball& ball : balls) ball.radius_m = std::min(ball.radius_m, (start_W - ball.p_W).norm() - 0.01);
  return balls;
}

}  // namespace

PathSearch::PathSearch(const PlanningMap& map, const VehicleLimits& limits, double margin_m)
    : PathSearch(std::make_shared<ReachableSet>(map, limits, margin_m), limits, margin_m) {}

PathSearch::PathSearch(std::shared_ptr<ReachableSet> reachable, const VehicleLimits& limits, double margin_m)
    : limits_(limits),
      reachable_(std::move(reachable)),
      hopeful_(reachable_->space().map(), limits, margin_m, Unknown::kFree),
      coarse_(reachable_->space().map().grid(), 2),
      fine_(reachable_->space().map().grid(), 1) {}

std::optional<Path> PathSearch::Find(const Eigen::Vector3d& start_W, const Eigen::Vector3d& goal_W,
                                     const std::vector<Ball>& avoid) {
  reachable_->Update(start_W);
  const SafeSpace& space = reachable_->space();
  const VoxelGrid& grid = space.map().grid();
  const std::optional<VoxelIndex> from = space.NearestSafeVoxel(start_W, 3.0);
  if (!from) return std::nullopt;
  const std::vector<Ball> balls = BallsAround(avoid, start_W);
  if (InsideABall(goal_W, balls)) return std::nullopt;

  Path path;
  path.limits = limits_;
  const bool at_goal = space.Slack(goal_W) >= 0 && reachable_->Reaches(goal_W);
  const std::optional<VoxelIndex> to =
      at_goal ? grid.IndexOf(goal_W) : reachable_->Nearest(goal_W, kGoalTolerance_m);
  std::vector<VoxelIndex> way;
  if (to) way = WayTo(*from, *to, balls);
  path.ends_at_goal = !way.empty();
  if (way.empty()) way = WayTowards(*from, goal_W, balls);
  if (way.empty()) return std::nullopt;

  std::vector<Eigen::Vector3d> points_W;
  const bool start_is_safe = space.Slack(start_W) >= 0;
  if (start_is_safe) points_W.push_back(start_W);
  for (const VoxelIndex& v : way) points_W.push_back(grid.Centre(v));
  if (path.ends_at_goal && at_goal) points_W.push_back(goal_W);
  if (path.ends_at_goal && !at_goal) points_W.push_back(grid.Centre(*to));
  points_W = Shorten(points_W, balls);
  if (!start_is_safe) points_W.insert(points_W.begin(), start_W);
  for (const Eigen::Vector3d& p_W : points_W) path.waypoints.push_back({p_W, space.FreeRadius(p_W)});
  return path;
}

std::vector<VoxelIndex> PathSearch::WayTo(const VoxelIndex& from, const VoxelIndex& to,
                                          const std::vector<Ball>& avoid) {
  if (!reachable_->Reaches(to)) return {};
  const SafeSpace& space = reachable_->space();
  const VoxelGrid& grid = space.map().grid();
  if (InsideABall(grid.Centre(to), avoid)) return {};
  const auto cost = [&](const VoxelIndex& v, std::size_t linear) -> std::uint32_t {
    if (!reachable_->ReachesInside(v)) return 0;
    if (!avoid.empty() && InsideABall(grid.Centre(v), avoid)) return 0;
    return space.RoomyVoxel(linear) ? kUnit : kUnit + 1;
  };
  std::vector<VoxelIndex> way = coarse_.Find(from, to, 1, kReachableMax, cost);
  if (way.empty()) way = fine_.Find(from, to, 0, kReachableMax, cost);
  return way;
}

std::vector<VoxelIndex> PathSearch::WayTowards(const VoxelIndex& from, const Eigen::Vector3d& goal_W,
                                               const std::vector<Ball>& avoid) {
  const SafeSpace& space = reachable_->space();
  const VoxelGrid& grid = space.map().grid();
  const VoxelIndex goal = grid.IndexOf(goal_W);
  const bool open = grid.Inside(goal) && space.OpenVoxel(grid.Linear(goal));
  const int tolerance = open ? 1 : static_cast<int>(std::ceil((limits_.radius_m + 0.5) / grid.voxel_m()));
  hopeful_.Update(grid.Centre(from));
  if (!hopeful_.Nearest(grid.Centre(goal), (tolerance + 1) * grid.voxel_m())) return {};
  const auto cost = [&](const VoxelIndex& v, std::size_t linear) -> std::uint32_t {
    if (!space.OpenVoxel(linear)) return 0;
    if (!avoid.empty() && InsideABall(grid.Centre(v), avoid)) return 0;
    if (!reachable_->ReachesInside(v)) return kUnit + 1;
    return space.RoomyVoxel(linear) ? kUnit : kUnit + 1;
  };
  std::vector<VoxelIndex> way = coarse_.Find(from, goal, tolerance, kHopefulMax, cost);
  if (way.empty()) way = coarse_.WayToNearest();
  const auto first_beyond = std::find_if(way.begin(), way.end(),
                                         [&](const VoxelIndex& v) { return !reachable_->ReachesInside(v); });
  way.erase(first_beyond, way.end());
  if (way.empty() || (grid.Centre(way.back()) - grid.Centre(from)).norm() < kShortest_m) return {};
  return way;
}

std::vector<Eigen::Vector3d> PathSearch::Shorten(const std::vector<Eigen::Vector3d>& points_W,
                                                 const std::vector<Ball>& avoid) const {
  const SafeSpace& space = reachable_->space();
  std::vector<Eigen::Vector3d> corners_W = {points_W.front()};
  // From every corner gallops ahead as long as the chord is safe, then halves back to the furthest safe one.
  for (std::size_t here = 0; here + 1 < points_W.size();) {
    std::size_t good = here + 1, stride = 2, bad = points_W.size();
    while (here + stride < bad) {
      if (!space.LegSafe(points_W[here], points_W[here + stride], avoid))
        bad = here + stride;
      else
        good = here + stride, stride *= 2;
    }
    if (bad == points_W.size() && space.LegSafe(points_W[here], points_W.back(), avoid)) good = bad - 1;
    while (good + 1 < bad) {
      const std::size_t middle = (good + bad) / 2;
      (space.LegSafe(points_W[here], points_W[middle], avoid) ? good : bad) = middle;
    }
    here = good;
    corners_W.push_back(points_W[here]);
  }
  for (std::size_t i = 1; i + 1 < corners_W.size();) {
    if (space.LegSafe(corners_W[i - 1], corners_W[i + 1], avoid))
      corners_W.erase(corners_W.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
  return corners_W;
}

}  // namespace citrine::planner

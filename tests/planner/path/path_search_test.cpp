#include "planner/path/path_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <queue>

#include "planner/path/topological_grid.h"
#include "tests/planner/path/synthetic_map.h"

namespace citrine::planner {
namespace {

using Eigen::Vector3d;

const VehicleLimits kLimits;
constexpr double kMargin_m = 0.1;

double LengthOf(const Path& path) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < path.waypoints.size(); ++i)
    length += (path.waypoints[i + 1].p_W - path.waypoints[i].p_W).norm();
  return length;
}

/// Least clearance to what is occupied along a path, by dense sampling.
double ClearanceOf(const Path& path, const PlanningMap& map) {
  double least = 1e9;
  for (std::size_t i = 0; i + 1 < path.waypoints.size(); ++i)
    for (double s = 0; s <= 1; s += 0.01)
      least = std::min(least, map.to_occupied().Interpolate(path.waypoints[i].p_W * (1 - s) +
                                                            path.waypoints[i + 1].p_W * s));
  return least;
}

TEST(PathSearch, GoesStraightThroughEmptySpace) {
  const PlanningMap map = MapOf({24, 24, 8}, EmptySpace);
  PathSearch search(map, kLimits, kMargin_m);
  const auto path = search.Find({3, 3, 4}, {20, 19, 5});
  ASSERT_TRUE(path);
  ASSERT_EQ(path->waypoints.size(), 2u);
  EXPECT_EQ(path->waypoints.front().p_W, Vector3d(3, 3, 4));
  EXPECT_EQ(path->waypoints.back().p_W, Vector3d(20, 19, 5));
  EXPECT_TRUE(path->ends_at_goal);
}

TEST(PathSearch, GoesThroughAGapOfThreeMetresForARobotOfOneMetreRadius) {
  const PlanningMap map = MapOf({20, 24, 8}, WallWithGap(15.1, 18.1));
  PathSearch search(map, kLimits, kMargin_m);
  const auto path = search.Find({4, 4, 4}, {16, 4, 4});
  ASSERT_TRUE(path);
  EXPECT_TRUE(path->ends_at_goal);
  // Legs between voxels may come under the margin by the fields' interpolation, never under the radius.
  EXPECT_GE(ClearanceOf(*path, map), kLimits.radius_m);
  // The shortest way around the edge at (9.75..10.25, 15.1 + 1.1): nearly 27 m; the lattice and the gap's
  // rounding add some.
  EXPECT_LT(LengthOf(*path), 30);
}

TEST(PathSearch, SaysThatAWalledOffGoalIsUnreachable) {
  const PlanningMap map = MapOf({20, 24, 8}, WallWithGap(15, 16.5));
  PathSearch search(map, kLimits, kMargin_m);
  EXPECT_FALSE(search.Find({4, 4, 4}, {16, 4, 4}));
}

TEST(PathSearch, ClampsAGoalInUnknownSpaceToTheKnownFreePart) {
  const PlanningMap map = MapOf({24, 12, 8}, EmptySpace, [](const Vector3d& p) { return p.x() < 12; });
  PathSearch search(map, kLimits, kMargin_m);
  const auto path = search.Find({3, 6, 4}, {20, 6, 4});
  ASSERT_TRUE(path);
  EXPECT_FALSE(path->ends_at_goal);
  // The first unknown voxel's centre lies at 12.125; a radius before it, a lattice step less at most.
  EXPECT_NEAR(path->waypoints.back().p_W.x(), 11.0, 0.55);
  EXPECT_GE(map.to_unknown().Interpolate(path->waypoints.back().p_W), kLimits.radius_m);
}

TEST(PathSearch, LeavesAPlaceThatIsSlightlyUnsafe) {
  const PlanningMap map = MapOf({20, 24, 8}, [](const Vector3d& p) { return p.x() - 2; });
  PathSearch search(map, kLimits, kMargin_m);
  const Vector3d start(2.8, 12, 4);
  ASSERT_LT(map.to_occupied().Interpolate(start), kLimits.radius_m);
  const auto path = search.Find(start, {12, 12, 4});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->waypoints.front().p_W, start);
  EXPECT_GE(map.to_occupied().Interpolate(path->waypoints[1].p_W), kLimits.radius_m);
}

TEST(PathSearch, StaysOutOfBallsThatItIsToAvoid) {
  const PlanningMap map = MapOf({24, 24, 8}, EmptySpace);
  PathSearch search(map, kLimits, kMargin_m);
  const Ball ball{{12, 12, 4}, 2.3};
  const auto path = search.Find({3, 12, 4}, {21, 12, 4}, {ball});
  ASSERT_TRUE(path);
  for (std::size_t i = 0; i + 1 < path->waypoints.size(); ++i)
    for (double s = 0; s <= 1; s += 0.02) {
      const Vector3d p = path->waypoints[i].p_W * (1 - s) + path->waypoints[i + 1].p_W * s;
      EXPECT_GE((p - ball.p_W).norm(),
                ball.radius_m - 0.1);  // a diagonal step of the lattice cuts in by less
    }
}

TEST(PathSearch, FindsTheSameWayEveryTime) {
  const Vector3d start(2.5, 2.5, 4), goal(21.5, 21, 4);
  const PlanningMap map = MapOf({24, 24, 8}, DistanceToForest(Forest(7, 24, 25, start, goal)));
  PathSearch first(map, kLimits, kMargin_m), second(map, kLimits, kMargin_m);
  second.Find(goal, start);  // a search before leaves no trace
  const auto a = first.Find(start, goal), b = second.Find(start, goal);
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->waypoints.size(), b->waypoints.size());
  for (std::size_t i = 0; i < a->waypoints.size(); ++i) EXPECT_EQ(a->waypoints[i].p_W, b->waypoints[i].p_W);
}

TEST(ReachableSet, EqualsAPlainFloodFill) {
  const Vector3d start(2.5, 2.5, 4);
  const auto known = [](const Vector3d& p) { return (p - Vector3d(12, 12, 4)).norm() < 14; };
  const PlanningMap map = MapOf({24, 24, 8}, DistanceToForest(Forest(3, 24, 30, start, start)), known);
  ReachableSet reachable(map, kLimits, kMargin_m);
  reachable.Update(start);
  ASSERT_TRUE(reachable.origin());
  const VoxelGrid& grid = map.grid();
  std::vector<bool> reached(grid.num_voxels(), false);
  std::queue<VoxelIndex> open;
  open.push(*reachable.origin());
  reached[grid.Linear(open.front())] = true;
  std::size_t count = 1;
  while (!open.empty()) {
    const VoxelIndex v = open.front();
    open.pop();
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) {
        const VoxelIndex next = v + side * VoxelIndex::Unit(axis);
        if (!reachable.space().SafeVoxel(next) || reached[grid.Linear(next)]) continue;
        reached[grid.Linear(next)] = true;
        ++count;
        open.push(next);
      }
  }
  ASSERT_GT(count, 1000u);
  EXPECT_EQ(reachable.size(), count);
  for (std::size_t i = 0; i < reached.size(); ++i)
    ASSERT_EQ(reachable.Reaches(grid.FromLinear(i)), reached[i]);
}

TEST(ReachableSet, FollowsTheMap) {
  PlanningMap map = MapOf({20, 24, 8}, WallWithGap(15, 16.5));
  ReachableSet reachable(map, kLimits, kMargin_m);
  reachable.Update({4, 4, 4});
  EXPECT_TRUE(reachable.Reaches(Vector3d(4, 20, 4)));
  EXPECT_FALSE(reachable.Reaches(Vector3d(16, 4, 4)));
  Write(WallWithGap(14, 19), Everywhere, 2, &map);
  reachable.Update({4, 4, 4});
  EXPECT_TRUE(reachable.Reaches(Vector3d(16, 4, 4)));
}

TEST(TopologicalGrid, MeasuresTheWayAroundAWall) {
  const PlanningMap map = MapOf({20, 24, 8}, WallWithGap(19, 23));
  TopologicalGrid cells(map);
  const Eigen::MatrixXd lengths = cells.LengthsBetween({{4, 4, 4}}, {{4, 12, 4}, {16, 4, 4}});
  EXPECT_NEAR(lengths(0, 0), 8, 1);
  // The straight legs through the opening's near and far edge are 2 x hypot(6, 15) = 32 m and 2 x hypot(6,
  // 18) = 38 m; a lattice's ways are up to 8 % longer.
  EXPECT_GT(lengths(0, 1), 32);
  EXPECT_LT(lengths(0, 1), 41);
}

TEST(TopologicalGrid, SaysInfinityWhereNothingConnects) {
  const PlanningMap map =
      MapOf({20, 24, 8}, EmptySpace, [](const Vector3d& p) { return p.x() < 6 || p.x() > 12; });
  TopologicalGrid cells(map);
  EXPECT_EQ(cells.LengthsBetween({{2, 4, 4}}, {{16, 4, 4}})(0, 0), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace citrine::planner

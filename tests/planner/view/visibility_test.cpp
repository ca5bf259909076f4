#include "planner/view/visibility.h"

#include <gtest/gtest.h>

#include "core/grid/ray_walk.h"
#include "planner/view/information_gain.h"
#include "tests/support/random_map.h"

namespace citrine::planner {
namespace {

std::vector<Element> All(const PlanningMap& map, ActiveSurface& surface) {
  surface.Update(map);
  return ListElements(map, surface, [](std::uint32_t) { return false; });
}

TEST(LookAt, CountsTheVoxelsOfAnIndependentWalkStrictlyInBetween) {
  testing::RandomMap world(11);
  ActiveSurface surface(world.map.grid(), world.map.quantisation(), QualityGoals());
  const std::vector<Element> elements = All(world.map, surface);
  const ClearCells clear_cells(world.map);
  int clear = 0, hidden = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const Element& e = elements[world.random().Below(static_cast<std::uint32_t>(elements.size()))];
    const Eigen::Vector3d view_W = world.Point({12, 10, 8});
    const VoxelIndex end = world.map.grid().IndexOf(view_W);
    bool occupied = false;
    int unknown = 0;
    WalkRay(world.map.grid(), e.p_W, view_W, [&](const VoxelIndex& v) {
      if (v == e.voxel || v == end) return true;
      const VoxelState state = world.map.state(world.map.grid().Linear(v));
      const bool own_surface = (v - e.voxel).cwiseAbs().maxCoeff() <= 1 && e.normal_W.dot(view_W - e.p_W) > 0;
      unknown += state == VoxelState::kUnknown;
      occupied |= state == VoxelState::kOccupied && !own_surface;
      return !occupied;
    });
    const Sight sight = LookAt(world.map, e, view_W);
    const Sight faster = LookAt(world.map, e, view_W, &clear_cells);
    ASSERT_EQ(faster.clear, sight.clear);
    ASSERT_EQ(faster.unknown, sight.unknown);
    ASSERT_EQ(sight.clear, !occupied);
    ASSERT_EQ(sight.unknown, unknown);
    EXPECT_DOUBLE_EQ(Visibility(sight), occupied ? 0 : std::exp(-unknown));
    ++(occupied ? hidden : clear);
  }
  EXPECT_GT(clear, 200);
  EXPECT_GT(hidden, 200);
}

TEST(DistanceWorth, HasTheThreeCasesOfEquation9AndNothingBeyondTheRange) {
  EXPECT_EQ(DistanceWorth(4.5, 4.5, 0.5, 10), 1);
  EXPECT_EQ(DistanceWorth(4.99, 4.5, 0.5, 10), 1);
  EXPECT_EQ(DistanceWorth(3.0, 4.5, 0.5, 10), 0.5);
  EXPECT_NEAR(DistanceWorth(8.0, 4.5, 0.5, 10), 0.1, 1e-12);
  EXPECT_EQ(DistanceWorth(10.01, 4.5, 0.5, 10), 0);
}

TEST(InformationGain, IsTheSumOverAllElementsAndItsBoundIsNeverBelowIt) {
  testing::RandomMap world(12);
  ActiveSurface surface(world.map.grid(), world.map.quantisation(), QualityGoals());
  const std::vector<Element> elements = All(world.map, surface);
  const SensorWindow window{LidarModel()};
  const InformationGain gain(world.map, elements, window, 0.5);
  for (int trial = 0; trial < 60; ++trial) {
    const Eigen::Vector3d view_W = world.Point({12, 10, 8});
    Gain expected;
    for (const Element& e : elements) {
      const double distance = (e.p_W - view_W).norm();
      const double elevation = std::asin((e.p_W - view_W).z() / distance) * 180 / EIGEN_PI;
      if (distance < 0.42 || distance > 10 || elevation < -35 || elevation > 30) continue;
      const Sight sight = LookAt(world.map, e, view_W);
      expected.visible += sight.clear;
      expected.sum += DistanceWorth(distance, 4.5, 0.5, 10) * Visibility(sight);
    }
    const Gain found = gain.Evaluate(view_W);
    const Gain bound = gain.Bound(view_W);
    EXPECT_EQ(found.visible, expected.visible);
    EXPECT_NEAR(found.sum, expected.sum, 1e-9);
    EXPECT_GE(bound.visible, found.visible);
    EXPECT_GE(bound.sum, found.sum);
  }
}

}  // namespace
}  // namespace citrine::planner

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
    for (const int most : {0, 1, 3, 1000}) {
      const Sight limited = LookAt(world.map, e, view_W, most);
      ASSERT_EQ(limited.clear, sight.clear && sight.unknown <= most);
      if (limited.clear) {
        ASSERT_EQ(limited.unknown, sight.unknown);
      }
    }
    ASSERT_EQ(sight.clear, !occupied);
    ASSERT_EQ(sight.unknown, unknown);
    EXPECT_DOUBLE_EQ(Visibility(sight), occupied ? 0 : std::exp(-unknown));
    ++(occupied ? hidden : clear);
  }
  EXPECT_GT(clear, 200);
  EXPECT_GT(hidden, 200);
}

TEST(LookAtEight, SeesWhatLookAtSeesEightTimes) {
  testing::RandomMap world(13);
  ActiveSurface surface(world.map.grid(), world.map.quantisation(), QualityGoals());
  const std::vector<Element> elements = All(world.map, surface);
  int hidden = 0, outside = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::array<const Element*, 8> eight;
    for (const Element*& e : eight)
      e = &elements[world.random().Below(static_cast<std::uint32_t>(elements.size()))];
    // Some views are outside the grid, some in line with a row of voxels, some next to or in an element.
    Eigen::Vector3d view_W = world.Point({16, 10, 8});
    if (trial % 4 == 1) view_W.tail<2>() = eight[0]->p_W.tail<2>();
    if (trial % 4 == 2) view_W = eight[3]->p_W + 0.25 * Eigen::Vector3d(trial % 3 - 1, trial % 5 - 2, 1);
    if (trial % 16 == 3) view_W = eight[7]->p_W;
    const std::array<Sight, 8> sights = LookAtEight(world.map, eight, view_W);
    for (int k = 0; k < 8; ++k) {
      const Sight sight = LookAt(world.map, *eight[k], view_W);
      ASSERT_EQ(sights[k].clear, sight.clear);
      ASSERT_EQ(sights[k].unknown, sight.unknown);
      hidden += !sight.clear;
    }
    outside += !world.map.grid().Contains(world.map.grid().IndexOf(view_W));

    std::array<Eigen::Vector3d, 8> each_W;
    std::array<const Eigen::Vector3d*, 8> views_W;
    for (std::size_t k = 0; k < 8; ++k) {
      each_W[k] = world.Point({16, 10, 8});
      views_W[k] = &each_W[k];
    }
    const std::array<Sight, 8> of_each = LookAtEight(world.map, eight, views_W);
    for (std::size_t k = 0; k < 8; ++k) {
      const Sight sight = LookAt(world.map, *eight[k], each_W[k]);
      ASSERT_EQ(of_each[k].clear, sight.clear);
      ASSERT_EQ(of_each[k].unknown, sight.unknown);
    }
  }
  EXPECT_GT(hidden, 1000);
  EXPECT_LT(hidden, 15000);
  EXPECT_GT(outside, 50);
}

TEST(DistanceWorth, HasTheThreeCasesOfEquation9AndNothingBeyondTheRange) {
  EXPECT_EQ(DistanceWorth(4.5, 4.5, 0.5, 10), 1);
  EXPECT_EQ(DistanceWorth(4.99, 4.5, 0.5, 10), 1);
  EXPECT_EQ(DistanceWorth(3.0, 4.5, 0.5, 10), 0.5);
  EXPECT_NEAR(DistanceWorth(8.0, 4.5, 0.5, 10), 0.1, 1e-12);
  EXPECT_EQ(DistanceWorth(10.01, 4.5, 0.5, 10), 0);
}

TEST(InformationGain, IsTheSumOverAllElementsAndItsBoundsAreNeverBelowIt) {
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
    Eigen::AlignedBox3d box(view_W);
    box.extend(view_W + world.Point({3, 3, 3}));
    for (int i = 0; i < 10; ++i) {
      const Eigen::Vector3d in_box_W = box.min() + world.Point(box.sizes());
      EXPECT_GE(gain.Bound(box).visible, gain.Evaluate(in_box_W).visible);
      EXPECT_GE(gain.Bound(box).sum, gain.Evaluate(in_box_W).sum);
    }
  }
}

TEST(InformationGain, OfOneElementIsItsWorthTimesItsVisibilityToTheBit) {
  testing::RandomMap world(14);
  ActiveSurface surface(world.map.grid(), world.map.quantisation(), QualityGoals());
  const std::vector<Element> elements = All(world.map, surface);
  const SensorWindow window{LidarModel()};
  int seen = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Element& e = elements[world.random().Below(static_cast<std::uint32_t>(elements.size()))];
    const Eigen::Vector3d view_W = world.Point({12, 10, 8}), to = e.p_W - view_W;
    const Gain found = InformationGain(world.map, {e}, window, 0.5).Evaluate(view_W);
    const Sight sight = LookAt(world.map, e, view_W);
    const double worth = DistanceWorth(to.norm(), e.d_star_m, 0.5, window.range_max_m());
    ASSERT_EQ(found.visible, window.Sees(to) && sight.clear ? 1 : 0);
    ASSERT_EQ(found.sum, window.Sees(to) ? worth * Visibility(sight) : 0);
    seen += found.visible;
  }
  EXPECT_GT(seen, 100);
}

}  // namespace
}  // namespace citrine::planner

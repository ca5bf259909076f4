#include "planner/path/safe_space.h"

#include <bit>

#include <gtest/gtest.h>

#include "tests/support/random_map.h"

namespace citrine::planner {
namespace {

TEST(SafeSpace, TellsRowsOfVoxelsAsItTellsThemOneByOne) {
  testing::RandomMap world(5, {20, 12, 8}, 3);
  const VoxelGrid& grid = world.map.grid();
  const SafeSpace space(world.map, {.radius_m = 0.5}, 0.1);
  int safe = 0, asked = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const auto below = [&](int n) {
      return static_cast<int>(world.random().Below(static_cast<std::uint32_t>(n)));
    };
    const int begin = below(64), end = begin + below(65 - begin);
    const std::size_t first = world.random().Below(static_cast<std::uint32_t>(grid.num_voxels() - 64));
    std::uint64_t expected = 0;
    for (int i = begin; i < end; ++i)
      expected |= std::uint64_t{space.SafeVoxel(first + static_cast<std::size_t>(i))} << i;
    ASSERT_EQ(space.SafeVoxels(first, begin, end), expected) << first << ' ' << begin << ' ' << end;
    safe += std::popcount(expected);
    asked += end - begin;
  }
  EXPECT_GT(safe, 0.01 * asked);
  EXPECT_LT(safe, 0.99 * asked);
}

TEST(SafeSpace, IsSafeWhereThereIsNoLackOfClearance) {
  testing::RandomMap world(5, {20, 12, 8}, 3);
  const SafeSpace space(world.map, {.radius_m = 0.5}, 0.1);
  const Eigen::AlignedBox3d& volume_W = world.map.grid().volume_W();
  int safe = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    Eigen::Vector3d p_W;
    for (int axis = 0; axis < 3; ++axis)
      p_W[axis] = world.random().Uniform(volume_W.min()[axis] - 0.5, volume_W.max()[axis] + 0.5);
    ASSERT_EQ(space.Safe(p_W), space.Slack(p_W) >= 0) << p_W.transpose();
    safe += space.Safe(p_W);
  }
  EXPECT_GT(safe, 200);
  EXPECT_LT(safe, 19800);
}

}  // namespace
}  // namespace citrine::planner

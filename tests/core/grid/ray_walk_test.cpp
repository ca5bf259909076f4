#include "core/grid/ray_walk.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"

namespace citrine {
namespace {

VoxelGrid Grid() { return VoxelGrid(0.25, {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(8, 8, 8)}, 0); }

std::vector<VoxelIndex> Walk(const VoxelGrid& grid, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  std::vector<VoxelIndex> visited;
  EXPECT_TRUE(WalkRay(grid, a, b, [&](const VoxelIndex& v) { return visited.push_back(v), true; }));
  return visited;
}

TEST(RayWalk, VisitsEveryVoxelOfTheSegmentOnceInOrderFaceByFace) {
  const VoxelGrid grid = Grid();
  Random random(1);
  const auto point = [&] {
    return Eigen::Vector3d(random.Uniform(0, 8), random.Uniform(0, 8), random.Uniform(0, 8));
  };
  for (int k = 0; k < 300; ++k) {
    const Eigen::Vector3d a = point(), b = point();
    const std::vector<VoxelIndex> visited = Walk(grid, a, b);
    ASSERT_EQ(visited.front(), grid.IndexOf(a));
    ASSERT_EQ(visited.back(), grid.IndexOf(b));
    for (std::size_t i = 1; i < visited.size(); ++i)
      ASSERT_EQ((visited[i] - visited[i - 1]).cwiseAbs().sum(), 1);
    // Points along the segment lie in visited voxels, in the same order.
    std::size_t at = 0;
    for (int s = 0; s <= 2000; ++s) {
      const VoxelIndex v = grid.IndexOf(a + (b - a) * (s / 2000.0));
      while (at < visited.size() && visited[at] != v) ++at;
      ASSERT_LT(at, visited.size());
    }
  }
}

TEST(RayWalk, StopsWhenToldTo) {
  int visits = 0;
  EXPECT_FALSE(WalkRay(Grid(), Eigen::Vector3d(0.1, 0.1, 0.1), Eigen::Vector3d(7, 0.1, 0.1),
                       [&](const VoxelIndex&) { return ++visits < 3; }));
  EXPECT_EQ(visits, 3);
}

TEST(RayWalk, PassesOverVoxelsOutsideTheGrid) {
  const std::vector<VoxelIndex> visited = Walk(Grid(), {-3, 0.1, 0.1}, {0.6, 0.1, 0.1});
  ASSERT_EQ(visited.size(), 3u);
  EXPECT_EQ(visited.front(), VoxelIndex(0, 0, 0));
}

TEST(RayWalk, VisitsOneVoxelForASegmentWithoutLength) {
  EXPECT_EQ(Walk(Grid(), {1.1, 1.1, 1.1}, {1.1, 1.1, 1.1}).size(), 1u);
}

}  // namespace
}  // namespace citrine

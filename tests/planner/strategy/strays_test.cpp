#include "planner/strategy/strays.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace citrine::planner {
namespace {

VoxelGrid Grid() { return VoxelGrid(0.25, {Eigen::Vector3d(-8, -8, 0), Eigen::Vector3d(8, 8, 6)}, 0.75); }

Element At(const VoxelIndex& voxel, SurfaceClass kind = SurfaceClass::kLqse) {
  Element element;
  element.voxel = voxel;
  element.kind = kind;
  return element;
}

/// Voxels side by side along x from one on.
std::vector<Element> Row(const VoxelIndex& first, int count) {
  std::vector<Element> row;
  for (int i = 0; i < count; ++i) row.push_back(At(first + VoxelIndex(i, 0, 0)));
  return row;
}

TEST(Strays, AreFewerThanARowOfTheLengthAskedForHasVoxels) {
  std::vector<Element> two_metres = Row({20, 20, 10}, 8), a_voxel_more = two_metres;
  a_voxel_more.push_back(At({20, 21, 10}));
  LeaveStrays(two_metres, Grid(), 2);
  LeaveStrays(a_voxel_more, Grid(), 2);
  EXPECT_EQ(two_metres.size(), 0u);
  EXPECT_EQ(a_voxel_more.size(), 9u);
}

TEST(Strays, AreNoneWhereARowOfNoLengthIsAskedFor) {
  std::vector<Element> one = Row({20, 20, 10}, 1);
  LeaveStrays(one, Grid(), 0);
  EXPECT_EQ(one.size(), 1u);
}

TEST(Strays, AreOfLowQualityNotIncomplete) {
  std::vector<Element> elements = {At({20, 20, 10}, SurfaceClass::kIse), At({20, 20, 11})};
  LeaveStrays(elements, Grid(), 2);
  ASSERT_EQ(elements.size(), 1u);
  EXPECT_EQ(elements[0].kind, SurfaceClass::kIse);
}

TEST(Strays, HaveNobodyWithinAMetre) {
  // Whatever the cells: two that are a metre apart at most lie in the same or in neighbouring ones.
  for (int shift = 0; shift < 4; ++shift) {
    std::vector<Element> elements = Row({20 + shift, 20, 10}, 5);
    const std::vector<Element> others = Row({20 + shift, 23, 10}, 4);
    elements.insert(elements.end(), others.begin(), others.end());
    LeaveStrays(elements, Grid(), 2);
    EXPECT_EQ(elements.size(), 9u);
  }
}

TEST(Strays, AreWhatCountingPairsSays) {
  const VoxelGrid grid = Grid();
  Random random(3);
  for (int round = 0; round < 20; ++round) {
    std::vector<Element> elements;
    const Eigen::Vector3i size = grid.voxels();
    for (int i = 0; i < 200; ++i)
      elements.push_back(
          At({static_cast<int>(random.Below(size.x())), static_cast<int>(random.Below(size.y())),
              static_cast<int>(random.Below(size.z()))},
             random.Below(3) == 0 ? SurfaceClass::kIse : SurfaceClass::kLqse));
    std::vector<VoxelIndex> expected;
    for (const Element& a : elements) {
      int company = 0;
      for (const Element& b : elements)
        company += ((a.voxel.array() / 4 - b.voxel.array() / 4).abs() <= 1).all();
      if (a.kind == SurfaceClass::kIse || company > 3) expected.push_back(a.voxel);
    }
    LeaveStrays(elements, grid, 0.75);
    std::vector<VoxelIndex> kept;
    for (const Element& element : elements) kept.push_back(element.voxel);
    EXPECT_EQ(kept, expected);
    EXPECT_GT(kept.size(), 0u);
    EXPECT_LT(kept.size(), 200u);
  }
}

}  // namespace
}  // namespace citrine::planner

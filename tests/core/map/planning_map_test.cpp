#include "core/map/planning_map.h"

#include <gtest/gtest.h>

#include "core/digest.h"
#include "core/random.h"

namespace citrine {
namespace {

VoxelGrid Grid() { return VoxelGrid(0.25, {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(12, 8, 6)}, 0.75); }
Quantisation Codes() { return {0.5, 1 / (4.5 * 4.5)}; }

MapBlock RandomBlock(const VoxelGrid& grid, Random& random, std::uint32_t version) {
  MapBlock block;
  block.index = static_cast<int>(random.Below(grid.num_blocks()));
  block.version = version;
  for (int i = 0; i < kBlockVoxels; ++i) {
    block.distance[i] = random.Uniform() < 0.9 ? kFreeCode : static_cast<std::uint8_t>(random.Below(256));
    block.weight[i] = static_cast<std::uint8_t>(random.Below(256));
  }
  return block;
}

TEST(PlanningMap, CallsAVoxelUnknownEmptyOrOccupiedByItsDistance) {
  PlanningMap map(Grid(), Codes());
  MapBlock block;
  block.index = 5;
  block.version = 1;
  block.distance[0] = Codes().DistanceCode(0.26);
  block.distance[1] = Codes().DistanceCode(0.24);
  block.distance[2] = Codes().DistanceCode(-0.5);
  ASSERT_TRUE(map.Apply(block));
  const std::size_t first = map.grid().Linear(map.grid().BlockOrigin(5));
  EXPECT_EQ(map.state(first), VoxelState::kEmpty);
  EXPECT_EQ(map.state(first + 1), VoxelState::kOccupied);
  EXPECT_EQ(map.state(first + 2), VoxelState::kOccupied);
  EXPECT_EQ(map.state(first + 3), VoxelState::kUnknown);
}

TEST(PlanningMap, KeepsItsDistanceFieldsEqualToBruteForceWhileBlocksCome) {
  PlanningMap map(Grid(), Codes());
  const VoxelGrid& grid = map.grid();
  map.AssumeFree({{6, 4, 3}, 2.25});
  Random random(3);
  for (std::uint32_t version = 1; version <= 6; ++version) {
    for (int k = 0; k < 3; ++k) map.Apply(RandomBlock(grid, random, version));
    map.Update();
    std::vector<VoxelIndex> occupied, unknown;
    for (std::size_t i = 0; i < grid.num_voxels(); ++i) {
      const VoxelIndex v = grid.FromLinear(i);
      if (map.state(i) != VoxelState::kUnknown &&
          map.distance_m(i) < PlanningMap::kSiteBelow_vox * grid.voxel_m())
        occupied.push_back(v);
      if (map.state(i) == VoxelState::kUnknown && grid.Inside(v) &&
          (grid.Centre(v) - Eigen::Vector3d(6, 4, 3)).norm() > 2.25)
        unknown.push_back(v);
    }
    const auto nearest = [](const std::vector<VoxelIndex>& sites, const VoxelIndex& v, int radius) {
      int squared = radius * radius;
      for (const VoxelIndex& site : sites) squared = std::min(squared, (site - v).squaredNorm());
      return squared;
    };
    for (int k = 0; k < 300; ++k) {
      const std::size_t i = random.Below(static_cast<std::uint32_t>(grid.num_voxels()));
      ASSERT_EQ(map.to_occupied().squared_vox(i), nearest(occupied, grid.FromLinear(i), 12));
      ASSERT_EQ(map.to_unknown().squared_vox(i), nearest(unknown, grid.FromLinear(i), 6));
    }
  }
}

TEST(PlanningMap, CountsNothingOutsideTheVolumeAsUnknown) {
  PlanningMap map(Grid(), Codes());
  EXPECT_EQ(map.to_unknown().At(map.grid().Linear({0, 0, 0})), static_cast<float>(0.25 * std::sqrt(27.0)));
  EXPECT_EQ(map.to_unknown().At(map.grid().Linear(map.grid().inside_min())), 0.0f);
}

TEST(PlanningMap, TakesOnlyNewerVersionsOfABlock) {
  PlanningMap map(Grid(), Codes());
  Random random(4);
  MapBlock block = RandomBlock(map.grid(), random, 7);
  EXPECT_TRUE(map.Apply(block));
  MapBlock older = block;
  older.version = 6;
  older.distance.fill(1);
  const std::uint64_t digest = map.Digest();
  EXPECT_FALSE(map.Apply(older));
  EXPECT_EQ(map.Digest(), digest);
  EXPECT_TRUE(map.Update());
  EXPECT_FALSE(map.Update());
}

TEST(PlanningMap, DoesOnceWhatIsToBeDoneMeanwhileAndOnlyIfSomethingChanged) {
  PlanningMap map(Grid(), Codes());
  Random random(5);
  map.Apply(RandomBlock(map.grid(), random, 1));
  std::array<int, 3> calls{};
  const auto call = [&](std::size_t i) {
    return [&, i] { calls[i] += map.revision() == 1 && !map.changed_blocks().empty(); };
  };
  const std::vector<std::function<void()>> meanwhile{call(0), call(1), call(2)};
  EXPECT_TRUE(map.Update(meanwhile));
  EXPECT_FALSE(map.Update(meanwhile));
  EXPECT_EQ(calls, (std::array{1, 1, 1}));
}

TEST(PlanningMap, RefusesABlockThatTheGridDoesNotHave) {
  PlanningMap map(Grid(), Codes());
  MapBlock block;
  block.version = 1;
  block.index = map.grid().num_blocks();
  EXPECT_THROW(map.Apply(block), std::out_of_range);
}

TEST(PlanningMap, DigestsIndexDistancesAndWeightsInOrderOfBlocks) {
  PlanningMap map(Grid(), Codes());
  Random random(9);
  MapBlock a = RandomBlock(map.grid(), random, 1), b = RandomBlock(map.grid(), random, 1);
  a.index = 11;
  b.index = 4;
  map.Apply(a);
  map.Apply(b);
  Digest expected;
  for (const MapBlock* block : {&b, &a}) {
    const std::int32_t index = block->index;
    expected.Add(&index, 4);
    expected.Add(block->distance.data(), kBlockVoxels);
    expected.Add(block->weight.data(), kBlockVoxels);
  }
  EXPECT_EQ(map.Digest(), expected.value());
  EXPECT_EQ(map.num_blocks_known(), 2);
}

}  // namespace
}  // namespace citrine

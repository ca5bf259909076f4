#include "core/map/tsdf_map.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "core/grid/grid_around.h"

namespace citrine {
namespace {

TEST(TsdfMap, QuantisesWhatWasObservedAndNothingElse) {
  TsdfMap map(VoxelGrid(0.25, {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(4, 4, 4)}, 0.75), 0.5);
  const Quantisation codes(0.5, 0.05);
  TsdfBlock& block = map.Allocate(3);
  block.distance_m[0] = 0.1f, block.weight[0] = 0.3f, block.quality[0] = 0.05f;
  block.distance_m[1] = 0.5f, block.weight[1] = 0.3f,
  block.quality[1] = 0.05f;  // free: its weight does not travel
  block.distance_m[2] = 0.1f, block.weight[2] = 0.0f;
  map.MarkChanged(3);
  const MapBlock coded = map.Quantise(3, codes);
  EXPECT_EQ(coded.version, 1u);
  EXPECT_NEAR(codes.Distance(coded.distance[0]), 0.1, 0.5 / 254 + 1e-9);
  EXPECT_EQ(coded.weight[0], 255);
  EXPECT_EQ(coded.distance[1], kFreeCode);
  EXPECT_EQ(coded.weight[1], 0);
  EXPECT_EQ(coded.distance[2], kUnknownCode);
  EXPECT_EQ(map.Quantise(2, codes).version, 0u);
}

TEST(TsdfBlock, HasAPlaceOfItsOwnForEachVoxelAndBricksSideBySide) {
  std::vector<int> seen(kBlockVoxels, 0);
  for (int z = 0; z < kBlockSide; ++z)
    for (int y = 0; y < kBlockSide; ++y)
      for (int x = 0; x < kBlockSide; ++x) {
        const int i = TsdfBlock::IndexOf({x, y, z});
        ++seen[i];
        EXPECT_EQ(i % kBrickVoxels, x % 2 + 2 * (y % 2) + 4 * (z % 2));
        EXPECT_EQ(i / kBrickVoxels, TsdfBlock::IndexOf({x - x % 2, y - y % 2, z - z % 2}) / kBrickVoxels);
        EXPECT_EQ(i, TsdfBlock::IndexOf({x + 16, y + 8, z + 80}));
      }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), kBlockVoxels);
}

TEST(TsdfMap, KeepsEveryBlockWhereItStandsWhenItGrows) {
  TsdfMap map(GridAround(0.25, {Eigen::Vector3d(0.1, 0.1, 0.1), Eigen::Vector3d(5, 3, 3)}), 0.5);
  std::vector<std::pair<Eigen::Vector3d, const TsdfBlock*>> blocks;
  for (int block = 0; block < map.grid().num_blocks(); block += 2)
    blocks.emplace_back(map.grid().Centre(map.grid().BlockOrigin(block)), &map.Allocate(block));
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-7.3, 1, 1), Eigen::Vector3d(2, 9, 2));
  map.GrowTo(box);
  EXPECT_TRUE(map.grid().volume_W().contains(box));
  for (const auto& [centre_W, block] : blocks)
    EXPECT_EQ(map.Find(map.grid().Block(map.grid().IndexOf(centre_W))), block);
  const int blocks_now = map.grid().num_blocks();
  map.GrowTo(box);
  EXPECT_EQ(map.grid().num_blocks(), blocks_now);
}

TEST(Quantisation, NeverTakesAWeightShortOfTheGoalForOneThatReachedIt) {
  const Quantisation codes(0.5, 0.05);
  for (const double share : {0.01, 0.5, 0.98, 0.99, 0.995, 0.9998}) {
    EXPECT_LT(codes.WeightCode(share * 0.05), 255) << share;
    EXPECT_NEAR(codes.Weight(codes.WeightCode(share * 0.05)) / (share * 0.05), 1, 0.02) << share;
  }
  EXPECT_EQ(codes.WeightCode(0.9999 * 0.05), 255);
}

}  // namespace
}  // namespace citrine

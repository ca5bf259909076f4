#include "core/map/tsdf_map.h"

#include <gtest/gtest.h>

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

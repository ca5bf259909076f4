#include "fusion/map_fuser.h"

#include <gtest/gtest.h>

#include "core/map/planning_map.h"
#include "fusion/block_rotation.h"
#include "fusion/teammate_filter.h"
#include "tests/support/analytic_scene.h"

namespace citrine::fusion {
namespace {

using test::AnalyticScene;

VoxelGrid Grid() { return VoxelGrid(0.25, {Eigen::Vector3d(-10, -10, 0), Eigen::Vector3d(10, 10, 6)}, 0.75); }
Quantisation Codes() { return {0.5, 1 / (4.5 * 4.5)}; }

AnalyticScene Scene() {
  AnalyticScene scene;
  scene.AddHalfSpace(Eigen::Vector3d::UnitZ(), 0);
  scene.AddBox({3, -2, 0}, {5, 2, 3});
  return scene;
}
LidarScan ScanFrom(const AnalyticScene& scene, double x, double y) {
  return scene.Scan({{x, y, 2.5}, Eigen::Quaterniond::Identity()});
}

TEST(MapFuser, SaysABlockAgainOnlyWhenItsCodesHaveChanged) {
  MapFuser fuser(Grid(), 0.5, Codes(), WeightPolicy::kBestView);
  const AnalyticScene scene = Scene();
  for (int k = 0; k < 3; ++k) fuser.Integrate(ScanFrom(scene, 0, 0));
  EXPECT_GT(fuser.TakeChanged().size(), 50u);
  const std::int64_t version = fuser.map_version();
  EXPECT_GT(version, 0);
  EXPECT_TRUE(fuser.TakeChanged().empty());
  EXPECT_EQ(fuser.map_version(), version);
  for (int k = 0; k < 3; ++k) fuser.Integrate(ScanFrom(scene, 0, 0));
  // The same noiseless scan again says nothing that the quantised map did not know, but for averages still
  // settling.
  EXPECT_LT(fuser.TakeChanged().size(), 10u);
  fuser.Integrate(ScanFrom(scene, 1.5, 1));
  EXPECT_GT(fuser.TakeChanged().size(), 10u);
  EXPECT_GT(fuser.map_version(), version);
}

TEST(MapFuser, SaysWhatDecidesAtOnceAndSmallDriftsInTurn) {
  MapFuser fuser(Grid(), 0.5, Codes(), WeightPolicy::kBestView);
  const AnalyticScene scene = Scene();
  Random random(1);
  const auto noisy = [&](double x) {
    fuser.Integrate(scene.Scan({{x, 0, 2.5}, Eigen::Quaterniond::Identity()}, {}, 1.5e-4, &random));
  };
  for (int k = 0; k < 20; ++k) noisy(0);
  fuser.TakeChanged();
  for (int k = 0; k < 20; ++k) noisy(0);
  fuser.TakeChanged();
  int behind = 0, known = 0;
  for (int block = 0; block < Grid().num_blocks(); ++block) {
    const MapBlock* said = fuser.Said(block);
    if (!said) continue;
    ++known;
    const MapBlock now = fuser.map().Quantise(block, Codes());
    behind += said->distance != now.distance || said->weight != now.weight;
    for (int i = 0; i < kBlockVoxels; ++i) {
      const double said_m = Codes().Distance(said->distance[i]), now_m = Codes().Distance(now.distance[i]);
      EXPECT_EQ(said->distance[i] == kUnknownCode, now.distance[i] == kUnknownCode);
      if (now.distance[i] == kUnknownCode) continue;
      EXPECT_EQ(said_m > 0.25, now_m > 0.25);
      EXPECT_EQ(said_m < PlanningMap::kSiteBelow_vox * 0.25, now_m < PlanningMap::kSiteBelow_vox * 0.25);
      EXPECT_EQ(said->weight[i] == 255, now.weight[i] == 255);
      EXPECT_NEAR(said_m, now_m, MapFuser::kStillDistance * 0.5 / 127 + 1e-9);
    }
  }
  EXPECT_GT(behind, 0);  // noise goes on, and is not said
  for (int block = 0; block < Grid().num_blocks(); ++block) {
    if (!fuser.Said(block)) continue;
    fuser.Renew(block);
    EXPECT_EQ(fuser.Said(block)->distance, fuser.map().Quantise(block, Codes()).distance);
  }
  EXPECT_EQ(fuser.num_blocks_said(), known);
}

TEST(BlockRotation, HealsAHearerThatLostMessagesWithinOneRound) {
  MapFuser fuser(Grid(), 0.5, Codes(), WeightPolicy::kBestView);
  BlockRotation rotation(Grid().num_blocks(), 10);
  PlanningMap hearer(Grid(), Codes());
  Random random(1);
  const AnalyticScene scene = Scene();
  const auto say = [&](double lost_share) {
    for (const int block : rotation.Next(fuser.TakeChanged()))
      if (random.Uniform() >= lost_share) hearer.Apply(*fuser.Said(block));
    hearer.Update();
  };
  for (int k = 0; k < 8; ++k) {
    fuser.Integrate(ScanFrom(scene, -3 + 0.8 * k, -1));
    say(0.3);
  }
  EXPECT_NE(hearer.Digest(), fuser.Summary().digest);
  for (int k = 0; k < 10; ++k) say(0);
  EXPECT_EQ(hearer.Digest(), fuser.Summary().digest);
  EXPECT_EQ(hearer.num_blocks_known(), fuser.Summary().num_blocks);
}

TEST(BlockRotation, SaysChangedBlocksFirstAndEachBlockOnce) {
  BlockRotation rotation(100, 4);
  EXPECT_EQ(rotation.Next({3, 50, 99}), (std::vector<int>{3, 50, 99}));
  std::vector<int> rest;
  for (int k = 0; k < 4; ++k)
    for (const int block : rotation.Next({})) rest.push_back(block);
  std::sort(rest.begin(), rest.end());
  EXPECT_EQ(std::unique(rest.begin(), rest.end()) - rest.begin(), 3);
}

TEST(TeammateFilter, DropsReturnsOnOtherUavsAndNothingElse) {
  AnalyticScene scene = Scene();
  const Eigen::Vector3d teammate(-3, 1, 2.5);
  scene.AddSphere(teammate, kAirframe_m);
  LidarScan scan = ScanFrom(scene, 0, 0);
  const LidarScan without = ScanFrom(Scene(), 0, 0);
  int on_teammate = 0;
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i)
    on_teammate += scan.ranges_m[i] != without.ranges_m[i];
  ASSERT_GT(on_teammate, 10);
  EXPECT_EQ(DropTeammates(scan, {teammate + Eigen::Vector3d(0.05, -0.05, 0.05)}), on_teammate);
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i)
    EXPECT_TRUE(scan.ranges_m[i] == kInvalid || scan.ranges_m[i] == without.ranges_m[i]);
}

TEST(TeammateFilter, KeepsATeammateOutOfTheMap) {
  AnalyticScene scene = Scene();
  const Eigen::Vector3d teammate(-3, 1, 2.5);
  scene.AddSphere(teammate, kAirframe_m);
  LidarScan scan = ScanFrom(scene, 0, 0);
  DropTeammates(scan, {teammate});
  MapFuser fuser(Grid(), 0.5, Codes(), WeightPolicy::kBestView);
  fuser.Integrate(scan);
  const VoxelGrid& grid = fuser.map().grid();
  for (std::size_t i = 0; i < grid.num_voxels(); ++i) {
    const VoxelIndex v = grid.FromLinear(i);
    if ((grid.Centre(v) - teammate).norm() > 1) continue;
    const TsdfBlock* block = fuser.map().Find(grid.Block(v));
    const int at = TsdfBlock::IndexOf(v);
    EXPECT_FALSE(block && block->weight[at] > 0 && block->distance_m[at] < 0.25f);
  }
}

}  // namespace
}  // namespace citrine::fusion

#include "fusion/cloud_image.h"

#include <gtest/gtest.h>

#include "fusion/cloud_fuser.h"
#include "tests/support/analytic_scene.h"

namespace citrine::fusion {
namespace {

test::AnalyticScene Scene() {
  test::AnalyticScene scene;
  scene.AddHalfSpace(Eigen::Vector3d::UnitZ(), 0);
  scene.AddBox({3, -2, 0}, {5, 2, 3});
  return scene;
}
LidarScan ScanAt(const Eigen::Vector3d& p_W) { return Scene().Scan({p_W, Eigen::Quaterniond::Identity()}); }

std::vector<Eigen::Vector3f> PointsOf(const LidarScan& scan) {
  std::vector<Eigen::Vector3f> points_S;
  for (int row = 0; row < scan.model.rows; ++row)
    for (int col = 0; col < scan.model.cols; ++col)
      if (const float r = scan.ranges_m[row * scan.model.cols + col]; r > 0)
        points_S.push_back((scan.model.Direction(row, col) * r).cast<float>());
  return points_S;
}

TEST(CloudImage, HasEachPointInTheBeamThatItCameFromAndNothingWhereNoneCame) {
  const LidarScan scan = ScanAt({0, 0, 2.5});
  PointCloud cloud{
      .measured = 7, .X_WS = scan.X_WS, .range_min_m = 0.42, .range_max_m = 10, .points_S = PointsOf(scan)};
  std::reverse(cloud.points_S.begin(), cloud.points_S.end());
  const LidarScan binned = Binned(cloud, scan.model);
  EXPECT_EQ(binned.measured, 7);
  ASSERT_EQ(binned.ranges_m.size(), scan.ranges_m.size());
  for (std::size_t i = 0; i < scan.ranges_m.size(); ++i) {
    if (scan.ranges_m[i] > 0)
      EXPECT_NEAR(binned.ranges_m[i], scan.ranges_m[i], 1e-5);
    else
      EXPECT_EQ(binned.ranges_m[i], kInvalid);
  }
}

TEST(CloudImage, TakesTheNearestOfSeveralPointsAndLeavesOutWhatIsOutOfRange) {
  const LidarModel model;
  const Eigen::Vector3f along = model.Direction(10, 20).cast<float>();
  const PointCloud cloud{.measured = 0,
                         .X_WS = {},
                         .range_min_m = 1,
                         .range_max_m = 6,
                         .points_S = {4 * along, 3 * along, 5 * along, 0.5f * along, 7 * along, {0, 0, 5}}};
  const LidarScan binned = Binned(cloud, model);
  EXPECT_NEAR(binned.ranges_m[10 * model.cols + 20], 3, 1e-5);
  EXPECT_EQ(std::count(binned.ranges_m.begin(), binned.ranges_m.end(), kInvalid),
            static_cast<std::ptrdiff_t>(binned.ranges_m.size()) - 1);
}

TEST(CloudImage, GuessesTheRingsAndColumnsOfASpinningSensor) {
  LidarModel model;
  model.rows = 16;
  model.cols = 360;
  const LidarScan scan = Scene().Scan({{0, 0, 2.5}, Eigen::Quaterniond::Identity()}, model);
  // Rings that meet nothing within range cannot be known.
  const LidarModel guessed = GuessModel(PointsOf(scan), 0.42, 10);
  EXPECT_EQ(guessed.cols, 360);
  EXPECT_GE(guessed.rows, 6);
  EXPECT_NEAR(guessed.elevation_min_rad, model.elevation_min_rad, 1e-4);
  EXPECT_NEAR(guessed.row_step_rad(), model.row_step_rad(), 1e-4);
}

TEST(CloudImage, GivesPointsWithoutRingsAPixelEach) {
  Random random(1);
  std::vector<Eigen::Vector3f> points_S;
  for (int i = 0; i < 20000; ++i) {
    const double az = random.Uniform(-EIGEN_PI, EIGEN_PI), el = random.Uniform(-0.4, 0.4);
    points_S.push_back(
        5 * Eigen::Vector3f(std::cos(el) * std::cos(az), std::cos(el) * std::sin(az), std::sin(el)));
  }
  const LidarModel guessed = GuessModel(points_S, 0.42, 10);
  EXPECT_NEAR(static_cast<double>(guessed.num_beams()), 20000, 3000);
  EXPECT_EQ(GuessModel({}, 0.42, 10).rows, 0);
}

TEST(CloudFuser, MapsAsOneThatKnewTheVolumeFromTheBeginning) {
  CloudFuser growing({.range_min_m = 0.42, .range_max_m = 10});
  TsdfMap whole(VoxelGrid(0.25, {Eigen::Vector3d(-24, -24, -12), Eigen::Vector3d(24, 24, 24)}, 0), 0.5);
  TsdfIntegrator integrator(whole, WeightPolicy::kBestView);
  std::optional<LidarModel> model;
  for (int i = 0; i < 8; ++i) {
    const LidarScan scan = ScanAt({-8 + 2.0 * i, -6.0 + i, 2.5});
    const std::vector<Eigen::Vector3f> points_S = PointsOf(scan);
    EXPECT_EQ(growing.Integrate(points_S, scan.X_WS), points_S.size());
    if (!model) model = GuessModel(points_S, 0.42, 10);
    integrator.Integrate(Binned({0, scan.X_WS, 0.42, 10, points_S}, *model));
  }
  int blocks = 0;
  const VoxelGrid& grid = growing.map().grid();
  for (int block = 0; block < whole.grid().num_blocks(); ++block) {
    const TsdfBlock* full = whole.Find(block);
    if (!full) continue;
    ++blocks;
    const VoxelIndex there = grid.IndexOf(whole.grid().Centre(whole.grid().BlockOrigin(block)));
    ASSERT_TRUE(grid.Contains(there));
    const TsdfBlock* grown = growing.map().Find(grid.Block(there));
    ASSERT_NE(grown, nullptr);
    for (int i = 0; i < kBlockVoxels; ++i) ASSERT_NEAR(grown->distance_m[i], full->distance_m[i], 1e-4);
  }
  EXPECT_GT(blocks, 100);
}

}  // namespace
}  // namespace citrine::fusion

#include "sim/lidar/lidar_emulator.h"

#include <gtest/gtest.h>

#include "core/vehicle/airframe.h"
#include "tests/sim/box_world.h"

namespace citrine::sim {
namespace {

constexpr double kFloatTolerance_m = 1e-3;

std::shared_ptr<const RayScene> Floor() {
  return std::make_shared<RayScene>(BoxWorld({{"ground", Box(-50, -50, -1, 50, 50, 0)}}));
}

TEST(LidarEmulator, MeasuresTheFloorAsTrigonometryDoesAlsoWhenTilted) {
  const LidarModel model;
  const LidarEmulator emulator(Floor(), model, 0);
  Random random(1);
  const Pose X_WS{{1, 2, 3},
                  Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()) *
                      Eigen::AngleAxisd(0.2, Eigen::Vector3d::UnitX()) * Eigen::Quaterniond::Identity()};
  const LidarScan scan = emulator.Scan(123, X_WS, {}, random);
  EXPECT_EQ(scan.measured, 123);
  ASSERT_EQ(scan.ranges_m.size(), model.num_beams());
  int returns = 0;
  for (int row = 0; row < model.rows; ++row)
    for (int col = 0; col < model.cols; ++col) {
      const double down = -(X_WS.q * model.Direction(row, col)).z();
      const float range_m = scan.ranges_m[static_cast<std::size_t>(row) * model.cols + col];
      const double truth_m = down > 0 ? 3 / down : 1e9;
      if (std::abs(truth_m - model.range_max_m) < kFloatTolerance_m) continue;
      if (truth_m > model.range_max_m) {
        EXPECT_EQ(range_m, kNoReturn);
      } else {
        EXPECT_NEAR(range_m, truth_m, kFloatTolerance_m);
        ++returns;
      }
    }
  EXPECT_GT(returns, 1000);
}

// Of n samples the standard deviation is known to 1/sqrt(2n), the mean to sigma/sqrt(n); four of each are
// allowed.
TEST(LidarEmulator, AddsNoiseThatGrowsWithTheSquareOfRange) {
  LidarModel model;
  model.rows = 1;
  model.elevation_min_rad = model.elevation_max_rad = -0.5;
  model.cols = 8192;
  const double noise = 1e-3, truth_m = 2 / std::sin(0.5), sigma_m = noise * truth_m * truth_m;
  const LidarEmulator emulator(Floor(), model, noise);
  Random random(7);
  const LidarScan scan = emulator.Scan(0, {{0, 0, 2}, Eigen::Quaterniond::Identity()}, {}, random);
  double sum = 0, sum_sq = 0;
  for (const float range_m : scan.ranges_m)
    sum += range_m - truth_m, sum_sq += (range_m - truth_m) * (range_m - truth_m);
  const double n = static_cast<double>(scan.ranges_m.size());
  EXPECT_NEAR(sum / n, 0, 4 * sigma_m / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(sum_sq / n), sigma_m, 4 * sigma_m / std::sqrt(2 * n));
}

TEST(LidarEmulator, SaysInvalidBelowItsLeastRange) {
  const LidarModel model;
  const LidarEmulator emulator(Floor(), model, 0);
  Random random(1);
  const LidarScan scan = emulator.Scan(0, {{0, 0, 0.2}, Eigen::Quaterniond::Identity()}, {}, random);
  EXPECT_EQ(scan.ranges_m.at(0), kInvalid);  // 35 degrees down: 0.35 m
}

TEST(LidarEmulator, SeesTeammatesAsSpheresInFrontOfWhatIsBehindThem) {
  LidarModel model;
  model.cols = 8;
  model.rows = 1;
  model.elevation_min_rad = model.elevation_max_rad = 0;
  const LidarEmulator emulator(std::make_shared<RayScene>(BoxWorld({{"wall", Box(-9, 5, -9, 9, 6, 9)}})),
                               model, 0);
  Random random(1);
  const Pose X_WS{{0, 0, 0}, Eigen::Quaterniond::Identity()};
  const Eigen::Vector3d along = model.Direction(0, 5);
  const LidarScan alone = emulator.Scan(0, X_WS, {}, random);
  const LidarScan scan = emulator.Scan(0, X_WS, {4 * along, 20 * along, -0.1 * along}, random);
  EXPECT_NEAR(scan.ranges_m.at(5), 4 - kAirframeRadius_m, 1e-5);
  for (int col = 0; col < model.cols; ++col) {
    if (col == 5) continue;
    EXPECT_EQ(scan.ranges_m.at(col), alone.ranges_m.at(col));
  }
  EXPECT_GT(alone.ranges_m.at(5), 5);
}

TEST(LidarEmulator, IsTheSameForTheSameSeed) {
  const LidarEmulator emulator(Floor(), LidarModel(), 1.5e-4);
  const Pose X_WS{{0, 0, 2}, Eigen::Quaterniond::Identity()};
  Random a(3), b(3), c(4);
  const auto ranges_m = emulator.Scan(0, X_WS, {}, a).ranges_m;
  EXPECT_EQ(ranges_m, emulator.Scan(0, X_WS, {}, b).ranges_m);
  EXPECT_NE(ranges_m, emulator.Scan(0, X_WS, {}, c).ranges_m);
}

}  // namespace
}  // namespace citrine::sim

#include "fusion/range_bounds.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"
#include "fusion/voxel_observer.h"

namespace citrine::fusion {
namespace {

/// Ranges of walls, edges, sky and invalid beams, by chance.
LidarScan RandomScan(int rows, int cols, Random& random) {
  LidarScan scan;
  scan.model.rows = rows;
  scan.model.cols = cols;
  float range_m = 5;
  for (int i = 0; i < rows * cols; ++i) {
    if (random.Below(8) == 0) range_m = static_cast<float>(random.Uniform(random.Below(3) ? 0.5 : 9.5, 10));
    const auto kind = random.Below(10);
    scan.ranges_m.push_back(kind == 0 ? kNoReturn : kind == 1 ? kInvalid : range_m);
  }
  return scan;
}

constexpr double kTruncation_m = 0.5, kVoxel_m = 0.25;

/// Of one lane, all of which are asked the same.
struct Bounds {
  float band_begin_m, band_end_m;
  bool all_valid;
};
Bounds Of(const RangeBounds& bounds, int row, int rows, int col, int cols) {
  const RangeBounds::Bounds found = bounds.Of(_mm256_set1_epi32(row), _mm256_set1_epi32(rows),
                                              _mm256_set1_epi32(col), _mm256_set1_epi32(cols));
  const auto of_one = [](Lanes lanes) {
    alignas(32) float values[8];
    Store(values, lanes);
    for (const float value : values) EXPECT_EQ(value, values[0]);
    return values[0];
  };
  return {of_one(found.band_begin_m), of_one(found.band_end_m), found.all_valid.all()};
}

TEST(RangeBounds, HoldWhatVoxelsInEveryWindowAreToldBySearchingThem) {
  Random random(1);
  for (const auto& [rows, cols] : {std::pair{16, 90}, {32, 101}, {2, 8}, {3, 64}}) {
    const LidarScan scan = RandomScan(rows, cols, random);
    RangeImage image;
    image.Take(scan, kVoxel_m);
    const VoxelObserver observer(image, kVoxel_m, kTruncation_m);
    for (const double least_rad : {0.0, 2.5 * scan.model.col_step_rad()}) {
      RangeBounds bounds;
      bounds.Take(image, kTruncation_m, least_rad);
      for (int k = 0; k < 400; ++k) {
        const int row = static_cast<int>(random.Below(rows - 1)), col = static_cast<int>(random.Below(cols));
        const int more_rows = static_cast<int>(random.Below(std::min(rows - 1 - row, RangeBounds::kHighest)));
        const int more_cols =
            1 + static_cast<int>(random.Below(std::min(cols - 1, RangeBounds::kWidest - 1)));
        const Bounds found = Of(bounds, row, more_rows, col, more_cols);
        for (int i = 0; i < 8; ++i) {
          alignas(32) float x[8], y[8], z[8], distance_m[8];
          for (int lane = 0; lane < 8; ++lane) {
            const double elevation = scan.model.elevation_min_rad +
                                     (row + random.Uniform(0, more_rows + 1)) * scan.model.row_step_rad();
            const double azimuth =
                scan.model.Azimuth(0) + (col + random.Uniform(0, more_cols + 1)) * scan.model.col_step_rad();
            distance_m[lane] = static_cast<float>(random.Uniform(0.1, 10.4));
            x[lane] = static_cast<float>(distance_m[lane] * std::cos(elevation) * std::cos(azimuth));
            y[lane] = static_cast<float>(distance_m[lane] * std::cos(elevation) * std::sin(azimuth));
            z[lane] = static_cast<float>(distance_m[lane] * std::sin(elevation));
          }
          const Observation told = observer.Observe(observer.LookAt(Load(x), Load(y), Load(z)));
          for (int lane = 0; lane < 8; ++lane) {
            EXPECT_TRUE(!(Bits(told.in_band) >> lane & 1) || distance_m[lane] >= found.band_begin_m - 1e-3f);
            EXPECT_TRUE(!(Bits(told.said) >> lane & 1) || distance_m[lane] <= found.band_end_m + 1e-3f);
          }
        }
      }
    }
  }
}

TEST(RangeBounds, KnowWhetherAllOfEveryWindowIsValid) {
  Random random(2);
  const LidarScan scan = RandomScan(16, 90, random);
  RangeImage image;
  image.Take(scan, kVoxel_m);
  RangeBounds bounds;
  bounds.Take(image, kTruncation_m);
  int seen_valid = 0;
  for (int k = 0; k < 400; ++k) {
    const int row = static_cast<int>(random.Below(15)), col = static_cast<int>(random.Below(90));
    const int more_rows = static_cast<int>(random.Below(15 - row)),
              more_cols = static_cast<int>(random.Below(64));
    bool all_valid = true;
    for (int r = row; r <= row + more_rows + 1; ++r)
      for (int c = col; c <= col + more_cols + 1; ++c) all_valid &= scan.ranges_m[r * 90 + c % 90] >= 0;
    const Bounds found = Of(bounds, row, more_rows, col, more_cols);
    // The window may be larger than asked for, never smaller.
    EXPECT_TRUE(all_valid || !found.all_valid);
    seen_valid += found.all_valid;
  }
  EXPECT_GT(seen_valid, 0);
}

TEST(RangeBounds, KnowAWallFromItsEdgeAndFromSky) {
  LidarScan scan;
  scan.model.rows = 32;
  scan.model.cols = 128;
  scan.ranges_m.assign(32 * 128, 5.0f);
  for (int row = 0; row < 32; ++row) {
    for (int col = 64; col < 128; ++col) scan.ranges_m[row * 128 + col] = 8.0f;
    for (int col = 96; col < 112; ++col) scan.ranges_m[row * 128 + col] = kNoReturn;
  }
  RangeImage image;
  image.Take(scan, kVoxel_m);
  RangeBounds bounds;
  bounds.Take(image, kTruncation_m);
  constexpr float kSteps_m = 0.1f;  // of two codes
  const Bounds wall = Of(bounds, 14, 0, 30, 0), edge = Of(bounds, 14, 0, 63, 0),
               sky = Of(bounds, 14, 0, 100, 0);
  EXPECT_NEAR(wall.band_begin_m, 4.5, kSteps_m);
  EXPECT_NEAR(wall.band_end_m, 5.5, kSteps_m);
  EXPECT_NEAR(edge.band_begin_m, 4.5, kSteps_m);  // where it jumps: the nearer
  EXPECT_NEAR(edge.band_end_m, 8.5, kSteps_m);    // and the farther
  EXPECT_GT(sky.band_begin_m, 10);
  EXPECT_NEAR(sky.band_end_m, 10, kSteps_m);
}

}  // namespace
}  // namespace citrine::fusion

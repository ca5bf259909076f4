#include "fusion/range_bounds.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace citrine::fusion {
namespace {

/// Ranges of walls, edges, sky and invalid beams, by chance.
LidarScan RandomScan(int rows, int cols, Random& random) {
  LidarScan scan;
  scan.model.rows = rows;
  scan.model.cols = cols;
  float range_m = 5;
  for (int i = 0; i < rows * cols; ++i) {
    if (random.Below(8) == 0) range_m = static_cast<float>(random.Uniform(0.5, 10));
    const auto kind = random.Below(10);
    scan.ranges_m.push_back(kind == 0 ? kNoReturn : kind == 1 ? kInvalid : range_m);
  }
  return scan;
}

TEST(RangeBounds, HoldTheRangesOfEveryWindowAsBruteForceFindsThem) {
  constexpr double kNoReturn_m = 9;
  const float step_m = 10.0f / 252;  // ranges are kept in bytes
  Random random(1);
  for (const auto& [rows, cols] : {std::pair{16, 90}, {32, 101}, {1, 8}, {3, 64}}) {
    const LidarScan scan = RandomScan(rows, cols, random);
    RangeImage image;
    image.Take(scan, 0.25);
    RangeBounds bounds;
    bounds.Take(image, kNoReturn_m);
    for (int k = 0; k < 400; ++k) {
      const int row = static_cast<int>(random.Below(rows)), col = static_cast<int>(random.Below(cols));
      const int more_rows = static_cast<int>(random.Below(std::min(rows - row, RangeBounds::kHighest)));
      const int more_cols = 1 + static_cast<int>(random.Below(std::min(cols - 1, RangeBounds::kWidest - 1)));
      float nearest = 1e9f, farthest = 0;
      bool all_valid = true;
      for (int r = row; r <= row + more_rows; ++r)
        for (int c = col; c <= col + more_cols; ++c) {
          const float range_m = scan.ranges_m[r * cols + c % cols];
          if (range_m > 0) nearest = std::min(nearest, range_m), farthest = std::max(farthest, range_m);
          if (range_m == kNoReturn) farthest = std::max(farthest, static_cast<float>(kNoReturn_m));
          all_valid &= range_m >= 0;
        }
      const RangeBounds::Ranges found = bounds.Of(_mm256_set1_epi32(row), _mm256_set1_epi32(more_rows),
                                                  _mm256_set1_epi32(col), _mm256_set1_epi32(more_cols));
      alignas(32) float nearest_m[8], farthest_m[8];
      Store(nearest_m, found.nearest_m);
      Store(farthest_m, found.farthest_m);
      // The window may be larger than asked for, never smaller.
      EXPECT_LE(nearest_m[0], nearest);
      EXPECT_GE(farthest_m[7] + 1e-3f, farthest);
      EXPECT_TRUE(all_valid || !found.all_valid.any());
      EXPECT_GE(nearest_m[0], nearest_m[7]);
    }
    // A window of the least size is exact to within a step.
    const RangeBounds::Ranges all =
        bounds.Of(_mm256_set1_epi32(0), _mm256_set1_epi32(0), _mm256_set1_epi32(0), _mm256_set1_epi32(1));
    float nearest = 1e6f;
    for (int r = 0; r < std::min(rows, 2); ++r)
      for (int c = 0; c < 2; ++c)
        if (scan.ranges_m[r * cols + c] > 0) nearest = std::min(nearest, scan.ranges_m[r * cols + c]);
    alignas(32) float nearest_m[8];
    Store(nearest_m, all.nearest_m);
    EXPECT_NEAR(nearest_m[3], nearest, step_m + 1e-3f);
  }
}

TEST(RangeBounds, KnowAReturnAtTheEdgeOfASurfaceFromOneInsideOfIt) {
  LidarScan scan;
  scan.model.rows = 32;
  scan.model.cols = 128;
  scan.ranges_m.assign(32 * 128, 5.0f);
  for (int row = 0; row < 32; ++row)
    for (int col = 64; col < 128; ++col) scan.ranges_m[row * 128 + col] = 8.0f;
  RangeImage image;
  image.Take(scan, 0.25);
  RangeBounds bounds;
  bounds.Take(image, 9);
  const auto edge_m = [&](int col) {
    alignas(32) float edge[8];
    Store(edge,
          bounds.Of(_mm256_set1_epi32(14), _mm256_set1_epi32(1), _mm256_set1_epi32(col), _mm256_set1_epi32(1))
              .nearest_edge_m);
    return edge[0];
  };
  EXPECT_GT(edge_m(30), 10);  // one surface all around
  EXPECT_GT(edge_m(100), 10);
  EXPECT_NEAR(edge_m(63), 5, 0.05);  // where it jumps, the nearer
}

}  // namespace
}  // namespace citrine::fusion

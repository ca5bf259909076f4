#pragma once

#include "fusion/lanes.h"
#include "fusion/range_bounds.h"
#include "fusion/voxel_observer.h"

namespace citrine::fusion {

/// What a scan can say about eight balls of voxels at once (bricks, octants or blocks), before any voxel is
/// looked up.
struct BrickSight {
  int seen;    ///< one bit each: neither out of view nor all of it behind what was seen
  int passed;  ///< no return ends near it: all that can be said is that it is free
  int free;    ///< that can be said of all of it
};

/// Compares the nearest and farthest points of balls with the ranges in the window of the image that holds
/// them.
/// @param x,y,z  [m] centres in the sensor frame @param radius_m  of the centres of their voxels
inline BrickSight SightOf(Lanes x, Lanes y, Lanes z, float radius_m, const LidarModel& model,
                          const VoxelObserver& observer, const RangeBounds& bounds, float truncation_m) {
  const Lanes level2 = MulAdd(x, x, y * y), level = Sqrt(level2), distance_m = Sqrt(MulAdd(z, z, level2));
  const float last_row = static_cast<float>(model.rows - 1), cols = static_cast<float>(model.cols);
  const auto range_max_m = static_cast<float>(model.range_max_m);
  const auto pixel = observer.PixelOf(x, y, z);

  // asin(t) <= 1.0472 t for t <= 1/2; nearer than that anything may be seen.
  constexpr float kAsin = 1.0472f;
  const Lanes half_cols = Lanes(kAsin * radius_m * observer.cols_a_radian()) / Max(level, 1e-3f);
  const Lanes half_rows = Lanes(kAsin * radius_m * observer.rows_a_radian()) / distance_m;
  const Mask around = distance_m < 2 * radius_m, over_pole = level < 2 * radius_m;
  const Lanes low = pixel.row - half_rows, high = pixel.row + half_rows;
  const Mask out_of_view =
      (high < -0.5f) | (low > last_row + 0.5f) | (distance_m > range_max_m + truncation_m + radius_m);

  const Lanes last_cell = Max(last_row - 1.0f, 0.0f);
  const Lanes first_row = Min(Max(Floor(low), 0.0f), last_cell);
  const Lanes rows = Min(Max(Floor(high), 0.0f), last_cell) - first_row;
  const Lanes first_col = Floor(pixel.col - half_cols), num_cols = Floor(pixel.col + half_cols) - first_col;
  const Lanes col = first_col + Keep(first_col < 0.0f, cols);
  const Mask too_wide = around | over_pole | (rows > static_cast<float>(RangeBounds::kHighest)) |
                        (num_cols > static_cast<float>(RangeBounds::kWidest)) | (col < 0.0f) | (col >= cols);
  const auto index = [&](Lanes value) { return ToInt(Keep(Without(Mask::Everywhere(), too_wide), value)); };
  const RangeBounds::Bounds cells = bounds.Of(index(first_row), index(rows), index(col), index(num_cols));

  const Lanes far_m = distance_m + radius_m;
  const Mask before = far_m<cells.band_begin_m, behind = distance_m - radius_m> cells.band_end_m;
  const Mask passed = Without(before, too_wide);
  const Mask in_view = (low >= 0.0f) & (high <= last_row) & (far_m < range_max_m);
  BrickSight sight;
  sight.seen = Bits(Without(Mask::Everywhere(), Without(Without(behind, too_wide) | out_of_view, around)));
  sight.passed = Bits(passed);
  sight.free = Bits(passed & in_view & cells.all_valid);
  return sight;
}

}  // namespace citrine::fusion

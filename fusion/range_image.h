#pragma once

#include <cstdint>
#include <vector>

#include "core/sensor/lidar_scan.h"

namespace citrine::fusion {

/// Nearest and farthest return of a part of the image; beams without return count as farther than any range.
struct RangeBounds {
  float min_m, max_m;
  bool any_invalid;
};

/// One scan as an image of inverse ranges (rows: elevation, columns: azimuth), ready to be looked up by
/// direction.
///
/// Inverse range is linear in the direction's vector on a plane, whatever its incidence: q = n.u / c for n.p
/// = c. So it is interpolated instead of the range, and planes seen at a grazing angle are known by it.
class RangeImage {
 public:
  /// @param voxel_m  how far two neighbouring returns may lie apart and still belong to one surface
  RangeImage(const LidarScan& scan, double voxel_m);

  const LidarModel& model() const { return model_; }
  /// Rows of the arrays below: at least two, the last repeated where the model has one.
  int rows() const { return rows_; }
  /// Row stride: one more than the model's columns, the first repeated.
  int stride() const { return model_.cols + 1; }

  /// [1/m] 0: no return, -1: invalid.
  const float* inverse_range() const { return inverse_range_.data(); }
  /// Nonzero where the cell between (row, col) and (row + 1, col + 1) shows one continuous surface.
  const std::int32_t* one_surface() const { return one_surface_.data(); }

  /// Over rows [row_min, row_max] (clamped) and columns [col_min, col_max] (wrapped; may be negative or
  /// beyond a turn).
  RangeBounds Bounds(int row_min, int row_max, int col_min, int col_max) const;

 private:
  struct Level {
    int rows, cols;
    std::vector<RangeBounds> cells;
  };
  void LinkNeighbours(double voxel_m);
  void BuildPyramid();

  LidarModel model_;
  int rows_;
  std::vector<float> inverse_range_;
  std::vector<std::int32_t> one_surface_;
  std::vector<Level> levels_;  ///< halved in both directions from one to the next
};

}  // namespace citrine::fusion

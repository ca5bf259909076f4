#include "fusion/range_image.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace citrine::fusion {
namespace {

constexpr float kFar = std::numeric_limits<float>::max();
constexpr RangeBounds kNothing{kFar, 0.0f, false};

RangeBounds Join(const RangeBounds& a, const RangeBounds& b) {
  return {std::min(a.min_m, b.min_m), std::max(a.max_m, b.max_m), a.any_invalid || b.any_invalid};
}

float InverseRange(float range_m, const LidarModel& model) {
  if (range_m == kNoReturn || range_m > model.range_max_m) return 0.0f;
  return range_m >= model.range_min_m ? 1.0f / range_m : -1.0f;  // NaN is invalid as well
}

/// Whether b continues the line through a and b's predecessor `before_a`, to within `tolerance_m` of range at
/// b.
bool Continues(float before_a, float a, float b, float twice_cos_step, float tolerance_m) {
  const float nearest_to_zero = std::min(a, b);
  return before_a > 0 &&
         std::abs(before_a + b - twice_cos_step * a) < tolerance_m * nearest_to_zero * nearest_to_zero;
}

/// Whether returns b and c, of four in a row, belong to one surface: near each other, or on a plane with a or
/// d.
bool OneSurface(float a, float b, float c, float d, float twice_cos_step, float voxel_m) {
  if (!(b > 0 && c > 0)) return false;
  if (std::abs(b - c) < voxel_m * b * c) return true;
  return Continues(a, b, c, twice_cos_step, 0.6f * voxel_m) ||
         Continues(d, c, b, twice_cos_step, 0.6f * voxel_m);
}

}  // namespace

RangeImage::RangeImage(const LidarScan& scan, double voxel_m)
    : model_(scan.model), rows_(std::max(scan.model.rows, 2)) {
  if (scan.ranges_m.size() != model_.num_beams())
    throw std::invalid_argument("a scan needs a range for each beam");
  inverse_range_.resize(static_cast<std::size_t>(rows_) * stride());
  for (int row = 0; row < rows_; ++row) {
    const float* from =
        &scan.ranges_m[static_cast<std::size_t>(std::min(row, model_.rows - 1)) * model_.cols];
    float* to = &inverse_range_[static_cast<std::size_t>(row) * stride()];
    for (int col = 0; col < model_.cols; ++col) to[col] = InverseRange(from[col], model_);
    to[model_.cols] = to[0];
  }
  LinkNeighbours(voxel_m);
  BuildPyramid();
}

void RangeImage::LinkNeighbours(double voxel_m) {
  const int cols = model_.cols;
  const auto at = [&](int row, int col) {
    return row < 0 || row >= model_.rows ? -1.0f
                                         : inverse_range_[static_cast<std::size_t>(row) * stride() + col];
  };
  const auto voxel = static_cast<float>(voxel_m);
  const float cos_row = static_cast<float>(2 * std::cos(model_.row_step_rad())), cos_col = 2.0f;
  std::vector<std::uint8_t> up(static_cast<std::size_t>(rows_) * stride(), 0), left(up);
  for (int row = 0; row < model_.rows; ++row)
    for (int col = 0; col < cols; ++col) {
      const std::size_t i = static_cast<std::size_t>(row) * stride() + col;
      const float here = inverse_range_[i];
      if (!(here > 0)) continue;
      up[i] = OneSurface(at(row - 1, col), here, at(row + 1, col), at(row + 2, col), cos_row, voxel);
      left[i] = OneSurface(at(row, col == 0 ? cols - 1 : col - 1), here, at(row, col + 1),
                           at(row, (col + 2) % cols), cos_col, voxel);
    }
  one_surface_.assign(up.size(), 0);
  for (int row = 0; row + 1 < model_.rows; ++row)
    for (int col = 0; col < cols; ++col) {
      const std::size_t i = static_cast<std::size_t>(row) * stride() + col;
      const std::size_t next = col + 1 == cols ? i + 1 - cols : i + 1;
      one_surface_[i] = up[i] & up[next] & left[i] & left[i + stride()];
    }
}

void RangeImage::BuildPyramid() {
  Level base{model_.rows, model_.cols, {}};
  base.cells.reserve(model_.num_beams());
  for (int row = 0; row < model_.rows; ++row)
    for (int col = 0; col < model_.cols; ++col) {
      const float q = inverse_range_[static_cast<std::size_t>(row) * stride() + col];
      base.cells.push_back(q < 0   ? RangeBounds{kFar, 0.0f, true}
                           : q > 0 ? RangeBounds{1 / q, 1 / q, false}
                                   : RangeBounds{kFar, kFar, false});
    }
  levels_.push_back(std::move(base));
  while (levels_.back().rows > 1 || levels_.back().cols > 1) {
    const Level& fine = levels_.back();
    Level coarse{(fine.rows + 1) / 2, (fine.cols + 1) / 2, {}};
    coarse.cells.assign(static_cast<std::size_t>(coarse.rows) * coarse.cols, kNothing);
    for (int row = 0; row < fine.rows; ++row)
      for (int col = 0; col < fine.cols; ++col) {
        RangeBounds& cell = coarse.cells[static_cast<std::size_t>(row / 2) * coarse.cols + col / 2];
        cell = Join(cell, fine.cells[static_cast<std::size_t>(row) * fine.cols + col]);
      }
    levels_.push_back(std::move(coarse));
  }
}

RangeBounds RangeImage::Bounds(int row_min, int row_max, int col_min, int col_max) const {
  row_min = std::clamp(row_min, 0, model_.rows - 1);
  row_max = std::clamp(row_max, 0, model_.rows - 1);
  if (col_max - col_min + 1 >= model_.cols) col_min = 0, col_max = model_.cols - 1;
  if (col_max < 0) col_min += model_.cols, col_max += model_.cols;
  if (col_min >= model_.cols) col_min -= model_.cols, col_max -= model_.cols;
  std::size_t level = 0;
  while (level + 1 < levels_.size() &&
         ((row_max >> level) - (row_min >> level) > 2 || (col_max - col_min) >> level > 2))
    ++level;
  const Level& cells = levels_[level];
  const auto rows_of = [&](int first_col, int last_col) {
    RangeBounds bounds = kNothing;
    for (int row = row_min >> level; row <= row_max >> level; ++row)
      for (int col = first_col >> level; col <= last_col >> level; ++col)
        bounds = Join(bounds, cells.cells[static_cast<std::size_t>(row) * cells.cols + col]);
    return bounds;
  };
  // A part that crosses the seam is looked up on both sides of it.
  if (col_min < 0) return Join(rows_of(col_min + model_.cols, model_.cols - 1), rows_of(0, col_max));
  if (col_max >= model_.cols)
    return Join(rows_of(col_min, model_.cols - 1), rows_of(0, col_max - model_.cols));
  return rows_of(col_min, col_max);
}

}  // namespace citrine::fusion

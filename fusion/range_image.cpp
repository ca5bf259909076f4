#include "fusion/range_image.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "fusion/lanes.h"

namespace citrine::fusion {
namespace {

Lanes At(const float* from) { return _mm256_loadu_ps(from); }

Mask At(const std::uint32_t* from) {
  return {_mm256_castsi256_ps(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(from)))};
}

void Put(std::uint32_t* to, Mask mask) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), _mm256_castps_si256(mask.v));
}

/// Whether returns b and c, of four in a row, belong to one surface: near each other, or on a plane with a or
/// d, to within 0.6 voxel of range. On a plane q follows a cosine of the angle: before + after = 2 cos(step)
/// here.
Mask OneSurface(Lanes a, Lanes b, Lanes c, Lanes d, Lanes twice_cos_step, Lanes voxel_m) {
  if (!(b > 0.0f).any()) return Mask::Nowhere();
  const Lanes nearest_to_zero = Min(b, c);
  const Lanes tolerance = voxel_m * 0.6f * nearest_to_zero * nearest_to_zero;
  const Mask on_plane_with_a = (a > 0.0f) & (Abs(a + c - twice_cos_step * b) < tolerance);
  const Mask on_plane_with_d = (d > 0.0f) & (Abs(d + b - twice_cos_step * c) < tolerance);
  return (nearest_to_zero > 0.0f) & ((Abs(b - c) < voxel_m * b * c) | on_plane_with_a | on_plane_with_d);
}

/// [1/m] 0: no return, -1: invalid (NaN as well). Lowest bits are zero.
void InverseRanges(const float* ranges_m, int count, const LidarModel& model, float* inverse_range) {
  const Lanes min_m = static_cast<float>(model.range_min_m), max_m = static_cast<float>(model.range_max_m);
  const Lanes without_lowest_bit = _mm256_castsi256_ps(_mm256_set1_epi32(-2));
  const auto eight = [&](Lanes range_m) {
    const Lanes q = _mm256_and_ps((Lanes(1.0f) / range_m).v, without_lowest_bit.v);
    const Mask nothing = Mask{_mm256_cmp_ps(range_m.v, Lanes(kNoReturn).v, _CMP_EQ_OQ)} | (range_m > max_m);
    return Select(nothing, 0.0f, Select(range_m >= min_m, q, -1.0f));
  };
  int i = 0;
  for (; i + 8 <= count; i += 8) _mm256_storeu_ps(inverse_range + i, eight(At(ranges_m + i)).v);
  if (i == count) return;
  float rest[8] = {};
  std::copy(ranges_m + i, ranges_m + count, rest);
  _mm256_storeu_ps(rest, eight(At(rest)).v);
  std::copy_n(rest, count - i, inverse_range + i);
}

}  // namespace

void RangeImage::Take(const LidarScan& scan, double voxel_m) {
  if (scan.ranges_m.size() != scan.model.num_beams())
    throw std::invalid_argument("a scan needs a range for each beam");
  model_ = scan.model;
  rows_ = std::max(model_.rows, 2);
  const int cols = model_.cols;
  stride_ = kTurnedLeft + cols + kTurnedRight;
  inverse_range_.assign(static_cast<std::size_t>(rows_ + 3) * stride_, -1.0f);
  for (int row = 0; row < rows_; ++row) {
    float* to = &inverse_range_[kTurnedLeft + static_cast<std::size_t>(row + 1) * stride_];
    InverseRanges(&scan.ranges_m[static_cast<std::size_t>(std::min(row, model_.rows - 1)) * cols], cols,
                  model_, to);
    Turn(to);
  }
  LinkNeighbours(voxel_m);
}

void RangeImage::LinkNeighbours(double voxel_m) {
  const Lanes voxel = static_cast<float>(voxel_m), cos_col = 2.0f;
  const Lanes cos_row = static_cast<float>(2 * std::cos(model_.row_step_rad()));
  const int cols = model_.cols, lanes = (cols + 8) / 8 * 8;
  up_.assign(static_cast<std::size_t>(lanes) + 8, 0);
  left_.assign(2 * static_cast<std::size_t>(lanes), 0);
  const __m256 lowest_bit = _mm256_castsi256_ps(_mm256_set1_epi32(1));
  const auto link_left = [&](int row) {
    const float* at = inverse_range() + static_cast<std::ptrdiff_t>(row) * stride_;
    std::uint32_t* left = &left_[static_cast<std::size_t>(row % 2) * lanes];
    for (int col = 0; col < cols; col += 8)
      Put(left + col,
          OneSurface(At(at + col - 1), At(at + col), At(at + col + 1), At(at + col + 2), cos_col, voxel));
  };
  link_left(0);
  for (int row = 0; row + 1 < model_.rows; ++row) {
    link_left(row + 1);
    float* at = &inverse_range_[kTurnedLeft + static_cast<std::size_t>(row + 1) * stride_];
    const std::uint32_t *left = &left_[static_cast<std::size_t>(row % 2) * lanes],
                        *left_above = &left_[static_cast<std::size_t>((row + 1) % 2) * lanes];
    for (int col = 0; col < lanes; col += 8)
      Put(&up_[col], OneSurface(At(at + col - stride_), At(at + col), At(at + col + stride_),
                                At(at + col + 2 * static_cast<std::ptrdiff_t>(stride_)), cos_row, voxel));
    for (int col = 0; col < cols; col += 8) {
      const Mask across = At(left + col) & At(left_above + col);
      if (!across.any()) continue;
      const Mask one_surface = At(&up_[col]) & At(&up_[col + 1]) & across;
      _mm256_storeu_ps(at + col, _mm256_or_ps(At(at + col).v, _mm256_and_ps(one_surface.v, lowest_bit)));
    }
    Turn(at);
  }
}

void RangeImage::Turn(float* row) const {
  const int cols = model_.cols;
  for (int i = 0; i < kTurnedRight; ++i) row[cols + i] = row[i % cols];
  for (int i = 1; i <= kTurnedLeft; ++i) row[-i] = row[(kTurnedLeft * cols - i) % cols];
}

}  // namespace citrine::fusion

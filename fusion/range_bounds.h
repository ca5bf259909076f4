#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fusion/lanes.h"
#include "fusion/range_image.h"

namespace citrine::fusion {

/// Bounds of what the cells in windows of a range image can say, a cell being the four beams around a
/// direction (VoxelObserver), by tables of overlapping windows of 2^(a+1) x 2^(b+1) cells for all a and b.
///
/// Each window asked for lies in one that is less than four times as long and as wide.
class RangeBounds {
 public:
  static constexpr int kRowLevels = 6, kColLevels = 7;  ///< 2^level cells from one window to the next
  static constexpr int kWidest = 1 << (kColLevels - 1), kHighest = 1 << (kRowLevels - 1);

  /// Follows an image; memory of the one before is used again.
  /// @param truncation_m  how far before and behind a surface it is spoken of
  /// @param least_rad  extent of the smallest window that will be asked for: tables of finer ones are left
  /// out
  void Take(const RangeImage& image, double truncation_m, double least_rad = 0);

  struct Bounds {
    Lanes band_begin_m;  ///< nearer than this no surface is within the truncation; beyond every range if none
                         ///< is
    Lanes band_end_m;    ///< farther than this nothing is said
    Mask all_valid;      ///< whether no beam is invalid
  };
  /// Over rows of cells [row, row + rows] within the image and columns [col, col + cols], col in [0,
  /// model.cols); at most kHighest and kWidest more.
  Bounds Of(__m256i row, __m256i rows, __m256i col, __m256i cols) const;

 private:
  using Eight = std::array<std::int32_t, 8>;
  void Lay(int cell_rows, int cols);
  void CodeRow(const RangeImage& image, int row, float truncation_m);
  __m256i CodeOfReturns(const float* at, int stride, float truncation_m, float up, float left) const;
  void HalveLine(int words);
  void JoinCols(int row);
  void JoinRows(int level);
  std::uint32_t* Windows(int row_level, int row, int col_level) {
    return &windows_[static_cast<std::size_t>(first_row_[row_level] + row) * stride_ + first_col_[col_level]];
  }
  static int RowsOf(int rows, int level) { return ((rows - 1) >> level) + 1; }

  float steps_per_m_ = 1, m_per_step_ = 1, range_max_m_ = 0;
  int rows_ = 0, least_row_level_ = 0, least_col_level_ = 0, stride_ = 0;
  /// A byte each: the begin in steps, 255 less the end, and 0 where a beam is invalid: so that the least of
  /// each byte is that of a union.
  std::vector<std::uint32_t> line_, groups_, windows_;
  alignas(32) Eight first_row_{}, first_col_{};  ///< of a level's tables in the whole, by level
};

}  // namespace citrine::fusion

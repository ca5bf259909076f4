#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "fusion/lanes.h"
#include "fusion/range_image.h"

namespace citrine::fusion {

/// Nearest and farthest range in windows of a range image, by tables of overlapping windows of 2^a x 2^b
/// beams for all a and b: each window asked for lies in one that is at most four times as long and as wide.
class RangeBounds {
 public:
  static constexpr int kRowLevels = 6, kColLevels = 7;  ///< 2^level beams from one window to the next
  static constexpr int kWidest = 1 << (kColLevels - 1), kHighest = 1 << (kRowLevels - 1);

  /// Follows an image; memory of the one before is used again.
  /// @param no_return_m  the range that a beam without return has for the farthest
  void Take(const RangeImage& image, double no_return_m);

  struct Ranges {
    Lanes nearest_m;       ///< return; beyond every range if there is none
    Lanes nearest_edge_m;  ///< return that borders on a cell which is not one surface; likewise
    Lanes farthest_m;      ///< return; `no_return_m` if a beam has none; 0 if all are invalid
    Mask all_valid;
  };
  /// Over rows [row, row + rows] within the image and columns [col, col + cols], col in [0, model.cols); at
  /// most kHighest and kWidest more.
  Ranges Of(__m256i row, __m256i rows, __m256i col, __m256i cols) const;

 private:
  void CodeBeams(const RangeImage& image, float no_return_m);
  void JoinCols(int level);
  void JoinRows(int level);

  float steps_per_m_ = 1, m_per_step_ = 1;
  int rows_ = 0;
  /// Beams, then the tables: a byte each for the three ranges, in steps, the last as 255 less it, and one for
  /// validity, so that the least of each byte is that of a union.
  std::vector<std::uint32_t> beams_, windows_;
  std::array<std::int32_t, kRowLevels * 8> offset_{};  ///< of a level's table, by 8 a + b
  alignas(32) std::array<std::int32_t, 8> stride_{};   ///< of its rows, by b
};

}  // namespace citrine::fusion

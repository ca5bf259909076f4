#include "fusion/range_bounds.h"

#include <algorithm>
#include <cmath>

namespace citrine::fusion {
namespace {

constexpr int kTop = 255;          // of a code: nothing there
constexpr float kBeyond_m = 1e6f;  // what it stands for
constexpr int kSpare = 16;         // words after each row, so that whole registers may be read and written

__m256i LoadWords(const std::uint32_t* from) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
}
void StoreWords(std::uint32_t* to, __m256i words) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), words);
}
__m256i LoadEight(const std::array<std::int32_t, 8>& from) {
  return _mm256_load_si256(reinterpret_cast<const __m256i*>(from.data()));
}
__m256i Join(__m256i a, __m256i b) { return _mm256_min_epu8(a, b); }

/// Every other word of sixteen, from the first or the second on.
template <int kFirst>
__m256i EveryOther(__m256i low, __m256i high) {
  constexpr int kOrder = kFirst == 0 ? 0b10001000 : 0b11011101;
  const __m256 mixed = _mm256_shuffle_ps(_mm256_castsi256_ps(low), _mm256_castsi256_ps(high), kOrder);
  return _mm256_permute4x64_epi64(_mm256_castps_si256(mixed), 0b11011000);
}

/// Codes of a cell, each 0 to 255.
__m256i Word(__m256i band_begin, __m256i beyond_band_end, __m256i all_valid) {
  return _mm256_or_si256(_mm256_or_si256(band_begin, _mm256_slli_epi32(beyond_band_end, 8)),
                         _mm256_slli_epi32(all_valid, 16));
}

}  // namespace

void RangeBounds::Take(const RangeImage& image, double truncation_m, double least_rad) {
  const LidarModel& model = image.model();
  range_max_m_ = static_cast<float>(model.range_max_m);
  // The longest range stays below the top.
  steps_per_m_ = static_cast<float>((kTop - 3) / (model.range_max_m + 2 * truncation_m));
  m_per_step_ = 1 / steps_per_m_;
  const auto least_level = [&](double step_rad, int levels) {
    const double steps = step_rad > 0 ? least_rad / step_rad : 0;
    return std::clamp(static_cast<int>(std::log2(std::max(steps, 1.0))), 0, std::min(levels - 1, 3));
  };
  least_row_level_ = least_level(model.row_step_rad(), kRowLevels);
  least_col_level_ = least_level(model.col_step_rad(), kColLevels);
  Lay(image.rows() - 1, model.cols);

  const int words = static_cast<int>(line_.size()) - kSpare;
  const int groups = RowsOf(rows_, least_row_level_), group_words = (words >> least_col_level_) + kSpare;
  for (int row = 0; row < rows_; ++row) {
    CodeRow(image, row, static_cast<float>(truncation_m));
    for (int level = 0; level < least_col_level_; ++level) HalveLine(words >> level);
    std::uint32_t* group = &groups_[static_cast<std::size_t>(row >> least_row_level_) * group_words];
    const bool first = (row & ((1 << least_row_level_) - 1)) == 0;
    for (int i = 0; i < group_words; i += 8)
      StoreWords(group + i, first ? LoadWords(&line_[i]) : Join(LoadWords(group + i), LoadWords(&line_[i])));
  }
  for (int row = 0; row < groups; ++row) {
    const std::uint32_t* at = &groups_[static_cast<std::size_t>(row) * group_words];
    const std::uint32_t* above = row + 1 < groups ? at + group_words : at;
    std::uint32_t* to = Windows(least_row_level_, row, least_col_level_);
    for (int i = 0; i < group_words - kSpare; i += 8)
      StoreWords(to + i, Join(Join(LoadWords(at + i), LoadWords(at + i + 1)),
                              Join(LoadWords(above + i), LoadWords(above + i + 1))));
    JoinCols(row);
  }
  for (int level = least_row_level_ + 1; level < kRowLevels; ++level) JoinRows(level);
}

void RangeBounds::Lay(int cell_rows, int cols) {
  rows_ = cell_rows;
  // Windows of the widest level that begin in the last column reach into the next turn.
  const int words = (cols + 3 * kWidest) / kWidest * kWidest;
  line_.resize(static_cast<std::size_t>(words) + kSpare);
  stride_ = 0;
  for (int level = least_col_level_; level < kColLevels; ++level) {
    first_col_[level] = stride_;
    stride_ += (words >> level) + kSpare;
  }
  int rows = 0;
  for (int level = least_row_level_; level < kRowLevels; ++level) {
    first_row_[level] = rows;
    rows += RowsOf(rows_, level);
  }
  const auto at_least = [](std::vector<std::uint32_t>& table, std::size_t size) {
    if (table.size() < size) table.resize(size);
  };
  at_least(groups_, static_cast<std::size_t>(RowsOf(rows_, least_row_level_)) *
                            ((words >> least_col_level_) + kSpare) +
                        kSpare);
  at_least(windows_, static_cast<std::size_t>(rows) * stride_ + kSpare);
}

void RangeBounds::CodeRow(const RangeImage& image, int row, float truncation_m) {
  const LidarModel& model = image.model();
  const int cols = model.cols, words = static_cast<int>(line_.size()) - kSpare, stride = image.stride();
  const auto code = [&](float range_m) { return static_cast<int>(std::ceil(range_m * steps_per_m_)); };
  // Cells without any return: sky, sky and invalid beams, invalid beams alone.
  const __m256i none = _mm256_set1_epi32(kTop), sky_end = _mm256_set1_epi32(kTop - code(range_max_m_));
  const __m256i sky = Word(none, sky_end, none), some = Word(none, sky_end, _mm256_setzero_si256()),
                invalid = Word(none, none, _mm256_setzero_si256());
  const double steepest_rad =
      std::max(std::abs(model.Elevation(row)), std::abs(model.Elevation(std::min(row + 1, model.rows - 1))));
  const auto per_cos = static_cast<float>(std::min(1 / std::max(std::cos(steepest_rad), 1e-6), 20.0));
  const double row_step = model.rows > 1 ? model.row_step_rad() : model.col_step_rad();
  const auto up = static_cast<float>(1 / row_step),
             left = per_cos * static_cast<float>(1 / model.col_step_rad());
  const float* at = image.inverse_range() + static_cast<std::ptrdiff_t>(row) * stride;
  for (int col = 0; col < cols; col += 8, at += 8) {
    const Lanes lower = _mm256_loadu_ps(at), lower_left = _mm256_loadu_ps(at + 1),
                upper = _mm256_loadu_ps(at + stride), upper_left = _mm256_loadu_ps(at + stride + 1);
    const Lanes most = Max(Max(lower, lower_left), Max(upper, upper_left));
    if ((most > 0.0f).any()) {
      StoreWords(&line_[col], CodeOfReturns(at, stride, truncation_m, up, left));
      continue;
    }
    const Lanes least = Min(Min(lower, lower_left), Min(upper, upper_left));
    const __m256i with_sky = _mm256_blendv_epi8(sky, some, _mm256_castps_si256((least < 0.0f).v));
    StoreWords(&line_[col], _mm256_blendv_epi8(with_sky, invalid, _mm256_castps_si256((most < 0.0f).v)));
  }
  for (int col = cols; col < words + kSpare; ++col) line_[col] = line_[col - cols];
}

/// @param up,left  [1/rad] steps of rows and columns @return codes of eight cells, some with returns
__m256i RangeBounds::CodeOfReturns(const float* at, int stride, float truncation_m, float up,
                                   float left) const {
  const Lanes q00 = _mm256_loadu_ps(at), q01 = _mm256_loadu_ps(at + 1), q10 = _mm256_loadu_ps(at + stride),
              q11 = _mm256_loadu_ps(at + stride + 1);
  const Lanes most = Max(Max(q00, q01), Max(q10, q11)), least = Min(Min(q00, q01), Min(q10, q11));
  const Mask smooth = LowestBit(q00) & (least > 0.0f);
  const Lanes nearest_m = Lanes(1.0f) / Max(most, 1e-3f);

  // Of the returns, the farthest.
  const auto returned = [](Lanes q) { return Select(q > 0.0f, q, 1e6f); };
  const Lanes farthest_q = Min(Min(returned(q00), returned(q01)), Min(returned(q10), returned(q11)));
  const Lanes farthest_m = Lanes(1.0f) / Max(farthest_q, 1e-3f);
  const auto no_return = [](Lanes q) { return Mask{_mm256_cmp_ps(q.v, Lanes(0.0f).v, _CMP_EQ_OQ)}; };
  const Mask any_sky = no_return(q00) | no_return(q01) | no_return(q10) | no_return(q11);

  // One surface is spoken of along its normal, by the slopes of q at their steepest; else each beam speaks
  // for itself, and one without return up to its range.
  const Lanes rise = Max(Abs(q10 - q00), Abs(q11 - q01)) * up,
              turn = Max(Abs(q01 - q00), Abs(q11 - q10)) * left;
  const Lanes g = Sqrt(MulAdd(most, most, MulAdd(rise, rise, turn * turn)));
  const Lanes before_m = Select(smooth, g * nearest_m, 1.0f) * truncation_m;
  const Lanes behind_m = Select(smooth, Min(g * farthest_m, 2.0f), 1.0f) * truncation_m;
  const Lanes end_m = Max(farthest_m + behind_m, Keep(any_sky, range_max_m_));

  const Lanes steps = steps_per_m_;
  const auto nothing = _mm256_set1_epi32(kTop);
  const __m256i begin =
      ToInt(Select(most > 0.0f, Max((nearest_m - before_m) * steps, 0.0f), static_cast<float>(kTop)));
  const __m256i beyond_end = ToInt(Lanes(static_cast<float>(kTop)) - end_m * steps);
  const __m256i all_valid = _mm256_and_si256(_mm256_castps_si256((least >= 0.0f).v), nothing);
  return Word(begin, beyond_end, all_valid);
}

void RangeBounds::HalveLine(int words) {
  for (int i = 0; i < words; i += 16) {
    const __m256i low = LoadWords(&line_[i]), high = LoadWords(&line_[i + 8]);
    StoreWords(&line_[i / 2], Join(EveryOther<0>(low, high), EveryOther<1>(low, high)));
  }
}

void RangeBounds::JoinCols(int row) {
  for (int level = least_col_level_ + 1; level < kColLevels; ++level) {
    const std::uint32_t* at = Windows(least_row_level_, row, level - 1);
    std::uint32_t* to = Windows(least_row_level_, row, level);
    const int words = (static_cast<int>(line_.size()) - kSpare) >> level;
    // A window and the next but one, which begins where it ends.
    for (int i = 0; i < words; i += 8, at += 16)
      StoreWords(to + i, EveryOther<0>(Join(LoadWords(at), LoadWords(at + 2)),
                                       Join(LoadWords(at + 8), LoadWords(at + 10))));
  }
}

void RangeBounds::JoinRows(int level) {
  const int finer_rows = RowsOf(rows_, level - 1), rows = RowsOf(rows_, level);
  for (int row = 0; row < rows; ++row) {
    const std::uint32_t* at = Windows(level - 1, 2 * row, least_col_level_);
    const std::uint32_t* above =
        2 * row + 2 < finer_rows ? at + 2 * static_cast<std::ptrdiff_t>(stride_) : at;
    std::uint32_t* to = Windows(level, row, least_col_level_);
    for (int i = 0; i < stride_; i += 8) StoreWords(to + i, Join(LoadWords(at + i), LoadWords(above + i)));
  }
}

RangeBounds::Bounds RangeBounds::Of(__m256i row, __m256i rows, __m256i col, __m256i cols) const {
  const __m256i one = _mm256_set1_epi32(1);
  // The least level at which a window and the next hold both ends: ceil(log2 n), from the exponent of n - 1,
  // or one less.
  const auto level_for = [&](__m256i begin, __m256i count, int least) {
    const __m256i less = _mm256_sub_epi32(_mm256_max_epi32(count, one), one);
    const __m256i exponent = _mm256_srli_epi32(_mm256_castps_si256(ToFloat(less).v), 23);
    const __m256i level =
        _mm256_max_epi32(_mm256_sub_epi32(exponent, _mm256_set1_epi32(126)), _mm256_setzero_si256());
    const __m256i lower = _mm256_max_epi32(_mm256_sub_epi32(level, one), _mm256_set1_epi32(least));
    const __m256i apart = _mm256_sub_epi32(_mm256_srlv_epi32(_mm256_add_epi32(begin, count), lower),
                                           _mm256_srlv_epi32(begin, lower));
    return _mm256_sub_epi32(lower, _mm256_cmpgt_epi32(apart, one));
  };
  const __m256i a = level_for(row, rows, least_row_level_), b = level_for(col, cols, least_col_level_);
  const __m256i window_row =
      _mm256_add_epi32(_mm256_permutevar8x32_epi32(LoadEight(first_row_), a), _mm256_srlv_epi32(row, a));
  const __m256i window_col =
      _mm256_add_epi32(_mm256_permutevar8x32_epi32(LoadEight(first_col_), b), _mm256_srlv_epi32(col, b));
  const __m256i at = _mm256_add_epi32(_mm256_mullo_epi32(window_row, _mm256_set1_epi32(stride_)), window_col);
  const __m256i word = _mm256_i32gather_epi32(reinterpret_cast<const int*>(windows_.data()), at, 4);
  const auto byte = [&](int shift) {
    return ToFloat(_mm256_and_si256(_mm256_srli_epi32(word, shift), _mm256_set1_epi32(255)));
  };
  const Lanes top = static_cast<float>(kTop);
  const auto range_m = [&](Lanes code) { return Select(code < top, code * m_per_step_, kBeyond_m); };
  return {range_m(byte(0)), (top - byte(8)) * m_per_step_, byte(16) > 0.0f};
}

}  // namespace citrine::fusion

#include "fusion/range_bounds.h"

#include <algorithm>
#include <cmath>

namespace citrine::fusion {
namespace {

constexpr float kTop = 255.0f;     // codes of ranges
constexpr float kBeyond_m = 1e6f;  // of no return at all
constexpr int kSpare = 16;         // words after each row, so that whole registers may be read and written

__m256i LoadWords(const std::uint32_t* from) {
  return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
}
void StoreWords(std::uint32_t* to, __m256i words) {
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), words);
}
__m256i Join(__m256i a, __m256i b) { return _mm256_min_epu8(a, b); }

/// Every other word of sixteen.
__m256i EvenWords(__m256i low, __m256i high) {
  const __m256 even = _mm256_shuffle_ps(_mm256_castsi256_ps(low), _mm256_castsi256_ps(high), 0b10001000);
  return _mm256_permute4x64_epi64(_mm256_castps_si256(even), 0b11011000);
}

}  // namespace

void RangeBounds::Take(const RangeImage& image, double no_return_m) {
  const LidarModel& model = image.model();
  rows_ = model.rows;
  // The longest range stays below the top, which is that of windows without any.
  steps_per_m_ = static_cast<float>((kTop - 3) / model.range_max_m);
  m_per_step_ = 1 / steps_per_m_;
  // Windows of the widest level that begin in the last column reach into the next turn.
  const int widest_cols = (model.cols + 3 * kWidest) / kWidest * kWidest;
  std::size_t words = 0;
  for (int b = 0; b < kColLevels; ++b) stride_[b] = (widest_cols >> b) + kSpare;
  for (int a = 0; a < kRowLevels; ++a)
    for (int b = 0; b < kColLevels; ++b) {
      offset_[8 * a + b] = static_cast<std::int32_t>(words);
      words += static_cast<std::size_t>(((rows_ - 1) >> a) + 1) * stride_[b];
    }
  if (windows_.size() < words + kSpare) windows_.resize(words + kSpare);
  CodeBeams(image, static_cast<float>(no_return_m));
  for (int b = 1; b < kColLevels; ++b) JoinCols(b);
  for (int a = 1; a < kRowLevels; ++a) JoinRows(a);
}

void RangeBounds::CodeBeams(const RangeImage& image, float no_return_m) {
  const int cols = image.model().cols, stride = stride_[0], turned = stride - kSpare;
  beams_.resize(static_cast<std::size_t>(rows_) * stride + kSpare);
  const Lanes top = kTop, steps = steps_per_m_, no_return = std::ceil(no_return_m * steps_per_m_);
  // A beam is inside of a surface if the four cells around it are.
  const auto inner = [&](const float* at) {
    const auto smooth = [&](std::ptrdiff_t to) { return LowestBit(_mm256_loadu_ps(at + to)); };
    const std::ptrdiff_t below = -image.stride();
    return smooth(0) & smooth(-1) & smooth(below) & smooth(below - 1);
  };
  for (int row = 0; row < rows_; ++row) {
    const float* from = image.inverse_range() + static_cast<std::ptrdiff_t>(row) * image.stride();
    std::uint32_t* to = &beams_[static_cast<std::size_t>(row) * stride];
    for (int col = 0; col < cols; col += 8) {
      const Lanes q = _mm256_loadu_ps(from + col);
      const Mask returned = q > 0.0f;
      const Lanes range = Floor(steps / Max(q, 1e-3f));
      const __m256i nearest = ToInt(Select(returned, Min(range, top), top));
      const Lanes farthest = Select(returned, Min(range + 1.0f, top), Select(q < 0.0f, 0.0f, no_return));
      const __m256i edge = _mm256_or_si256(nearest, _mm256_castps_si256(Mask(inner(from + col)).v));
      const __m256i both =
          _mm256_or_si256(nearest, _mm256_slli_epi32(_mm256_and_si256(edge, _mm256_set1_epi32(255)), 8));
      const __m256i valid = ToInt(Keep(q >= 0.0f, top));
      const __m256i rest = _mm256_or_si256(ToInt(top - farthest), _mm256_slli_epi32(valid, 8));
      StoreWords(to + col, _mm256_or_si256(both, _mm256_slli_epi32(rest, 16)));
    }
    for (int col = cols; col < turned + 1; ++col) to[col] = to[col - cols];
  }
  // Windows of two rows and two columns, one from each beam.
  for (int row = 0; row < rows_; ++row) {
    const std::uint32_t* at = &beams_[static_cast<std::size_t>(row) * stride];
    const std::uint32_t* above = row + 1 < rows_ ? at + stride : at;
    std::uint32_t* to = &windows_[offset_[0] + static_cast<std::size_t>(row) * stride];
    for (int col = 0; col < turned; col += 8)
      StoreWords(to + col, Join(Join(LoadWords(at + col), LoadWords(at + col + 1)),
                                Join(LoadWords(above + col), LoadWords(above + col + 1))));
  }
}

void RangeBounds::JoinCols(int level) {
  const int wide = stride_[level] - kSpare;
  for (int row = 0; row < rows_; ++row) {
    const std::uint32_t* from =
        &windows_[offset_[level - 1] + static_cast<std::size_t>(row) * stride_[level - 1]];
    std::uint32_t* to = &windows_[offset_[level] + static_cast<std::size_t>(row) * stride_[level]];
    for (int col = 0; col < wide; col += 8) {
      // A window and the next but one, which begins where it ends.
      const std::uint32_t* at = from + 2 * static_cast<std::ptrdiff_t>(col);
      StoreWords(to + col, EvenWords(Join(LoadWords(at), LoadWords(at + 2)),
                                     Join(LoadWords(at + 8), LoadWords(at + 10))));
    }
  }
}

void RangeBounds::JoinRows(int level) {
  const int finer_rows = ((rows_ - 1) >> (level - 1)) + 1, rows = ((rows_ - 1) >> level) + 1;
  for (int b = 0; b < kColLevels; ++b)
    for (int row = 0; row < rows; ++row) {
      const std::size_t stride = static_cast<std::size_t>(stride_[b]);
      const std::uint32_t* at = &windows_[offset_[8 * (level - 1) + b] + 2 * row * stride];
      const std::uint32_t* above = 2 * row + 2 < finer_rows ? at + 2 * stride : at;
      std::uint32_t* to = &windows_[offset_[8 * level + b] + row * stride];
      for (int col = 0; col < stride_[b] - kSpare; col += 8)
        StoreWords(to + col, Join(LoadWords(at + col), LoadWords(above + col)));
    }
}

RangeBounds::Ranges RangeBounds::Of(__m256i row, __m256i rows, __m256i col, __m256i cols) const {
  // ceil(log2 n) of n >= 1, from the exponent of n - 1.
  const auto level_for = [](__m256i count) {
    const __m256i exponent =
        _mm256_srli_epi32(_mm256_castps_si256(ToFloat(_mm256_sub_epi32(count, _mm256_set1_epi32(1))).v), 23);
    return _mm256_max_epi32(_mm256_sub_epi32(exponent, _mm256_set1_epi32(126)), _mm256_setzero_si256());
  };
  const __m256i a = level_for(_mm256_max_epi32(rows, _mm256_set1_epi32(1)));
  const __m256i b = level_for(_mm256_max_epi32(cols, _mm256_set1_epi32(1)));
  const __m256i table =
      _mm256_i32gather_epi32(offset_.data(), _mm256_add_epi32(_mm256_slli_epi32(a, 3), b), 4);
  const __m256i stride =
      _mm256_permutevar8x32_epi32(_mm256_load_si256(reinterpret_cast<const __m256i*>(stride_.data())), b);
  const __m256i at =
      _mm256_add_epi32(_mm256_mullo_epi32(_mm256_srlv_epi32(row, a), stride), _mm256_srlv_epi32(col, b));
  const __m256i word =
      _mm256_i32gather_epi32(reinterpret_cast<const int*>(windows_.data()), _mm256_add_epi32(table, at), 4);
  const auto byte = [&](int shift) {
    return ToFloat(_mm256_and_si256(_mm256_srli_epi32(word, shift), _mm256_set1_epi32(255)));
  };
  const auto range_m = [&](Lanes code) { return Select(code < kTop, code * m_per_step_, kBeyond_m); };
  return {range_m(byte(0)), range_m(byte(8)), (Lanes(kTop) - byte(16)) * m_per_step_, byte(24) > 0.0f};
}

}  // namespace citrine::fusion

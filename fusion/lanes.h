#pragma once

#include <immintrin.h>

#include <initializer_list>

namespace citrine::fusion {

/// Eight floats side by side: a brick of a block.
struct Lanes {
  __m256 v;
  Lanes() = default;
  Lanes(__m256 value) : v(value) {}
  Lanes(float value) : v(_mm256_set1_ps(value)) {}
};
/// Eight truths, all bits set where true.
struct Mask {
  __m256 v;
  static Mask Everywhere() { return {_mm256_castsi256_ps(_mm256_set1_epi32(-1))}; }
  static Mask Nowhere() { return {_mm256_setzero_ps()}; }
  bool any() const { return _mm256_movemask_ps(v) != 0; }
  bool all() const { return _mm256_movemask_ps(v) == 0xff; }
};

inline Lanes operator+(Lanes a, Lanes b) { return _mm256_add_ps(a.v, b.v); }
inline Lanes operator-(Lanes a, Lanes b) { return _mm256_sub_ps(a.v, b.v); }
inline Lanes operator*(Lanes a, Lanes b) { return _mm256_mul_ps(a.v, b.v); }
inline Lanes operator/(Lanes a, Lanes b) { return _mm256_div_ps(a.v, b.v); }
inline Mask operator<(Lanes a, Lanes b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)}; }
inline Mask operator<=(Lanes a, Lanes b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)}; }
inline Mask operator>(Lanes a, Lanes b) { return b < a; }
inline Mask operator>=(Lanes a, Lanes b) { return b <= a; }
inline Mask operator!=(Lanes a, Lanes b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_NEQ_UQ)}; }
inline Mask operator&(Mask a, Mask b) { return {_mm256_and_ps(a.v, b.v)}; }
inline Mask operator|(Mask a, Mask b) { return {_mm256_or_ps(a.v, b.v)}; }
/// a and not b
inline Mask Without(Mask a, Mask b) { return {_mm256_andnot_ps(b.v, a.v)}; }

inline Lanes Load(const float* from) { return _mm256_load_ps(from); }
inline void Store(float* to, Lanes a) { _mm256_store_ps(to, a.v); }
inline Lanes Select(Mask mask, Lanes yes, Lanes no) { return _mm256_blendv_ps(no.v, yes.v, mask.v); }
/// `a` where the mask is set, 0 elsewhere.
inline Lanes Keep(Mask mask, Lanes a) { return _mm256_and_ps(mask.v, a.v); }
inline Mask Select(Mask mask, Mask yes, Mask no) { return {_mm256_blendv_ps(no.v, yes.v, mask.v)}; }
inline Lanes Min(Lanes a, Lanes b) { return _mm256_min_ps(a.v, b.v); }
inline Lanes Max(Lanes a, Lanes b) { return _mm256_max_ps(a.v, b.v); }
inline Lanes Sqrt(Lanes a) { return _mm256_sqrt_ps(a.v); }
inline Lanes Floor(Lanes a) { return _mm256_floor_ps(a.v); }
inline Lanes Round(Lanes a) { return _mm256_round_ps(a.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC); }
inline Lanes Abs(Lanes a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v); }
/// a b + c, rounded once.
inline Lanes MulAdd(Lanes a, Lanes b, Lanes c) { return _mm256_fmadd_ps(a.v, b.v, c.v); }
inline Lanes Mix(Lanes a, Lanes b, Lanes share) { return MulAdd(b - a, share, a); }
inline __m256i ToInt(Lanes a) { return _mm256_cvttps_epi32(a.v); }
inline Lanes ToFloat(__m256i a) { return _mm256_cvtepi32_ps(a); }
/// Where the lowest bit of a number is set.
inline Mask LowestBit(Lanes a) {
  return {_mm256_castsi256_ps(_mm256_srai_epi32(_mm256_slli_epi32(_mm256_castps_si256(a.v), 31), 31))};
}
/// One bit a lane.
inline int Bits(Mask a) { return _mm256_movemask_ps(a.v); }

/// table[index] and table[index + 1].
struct LanePair {
  Lanes first, second;
};
inline LanePair GatherPairs(const float* table, __m256i index) {
  const auto* pairs = reinterpret_cast<const long long*>(table);
  const auto four = [&](__m128i at) { return _mm256_castsi256_ps(_mm256_i32gather_epi64(pairs, at, 4)); };
  const __m256 low = four(_mm256_castsi256_si128(index)), high = four(_mm256_extracti128_si256(index, 1));
  const auto in_order = [](__m256 mixed) {
    return _mm256_castpd_ps(_mm256_permute4x64_pd(_mm256_castps_pd(mixed), 0b11011000));
  };
  return {in_order(_mm256_shuffle_ps(low, high, 0b10001000)),
          in_order(_mm256_shuffle_ps(low, high, 0b11011101))};
}

/// atan(t) for t in [0, 1], to within 5e-7 rad: an odd polynomial through the Chebyshev nodes.
inline Lanes AtanOfShare(Lanes t) {
  const Lanes s = t * t;
  Lanes p = 0.007648353926762766f;
  for (const float c : {-0.03636043085731773f, 0.08312645300619582f, -0.13447864058090495f,
                        0.19872040268214597f, -0.33325678039723927f, 0.9999992255890977f})
    p = MulAdd(p, s, c);
  return p * t;
}
/// Angle of (x, y) for x >= 0.
inline Lanes AtanRight(Lanes y, Lanes x) {
  const Lanes ay = Abs(y);
  const Lanes p = AtanOfShare(Min(x, ay) / Max(Max(x, ay), 1e-30f));
  return _mm256_or_ps(Select(ay > x, Lanes(1.57079632679f) - p, p).v,
                      _mm256_and_ps(y.v, _mm256_set1_ps(-0.0f)));
}
/// Angle of (x, y).
inline Lanes Atan2(Lanes y, Lanes x) {
  const Lanes ax = Abs(x), ay = Abs(y);
  Lanes p = AtanOfShare(Min(ax, ay) / Max(Max(ax, ay), 1e-30f));
  p = Select(ay > ax, Lanes(1.57079632679f) - p, p);
  p = Select(x < 0.0f, Lanes(3.14159265359f) - p, p);
  return _mm256_or_ps(p.v, _mm256_and_ps(y.v, _mm256_set1_ps(-0.0f)));
}

}  // namespace citrine::fusion

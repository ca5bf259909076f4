#pragma once

#include <immintrin.h>

#include <initializer_list>

namespace citrine::fusion {

/// Eight floats side by side: a row of a block.
struct Lanes {
  __m256 v;
  Lanes() = default;
  Lanes(__m256 value) : v(value) {}
  Lanes(float value) : v(_mm256_set1_ps(value)) {}
};
/// Eight truths, all bits set where true.
struct Mask {
  __m256 v;
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
inline Lanes Min(Lanes a, Lanes b) { return _mm256_min_ps(a.v, b.v); }
inline Lanes Max(Lanes a, Lanes b) { return _mm256_max_ps(a.v, b.v); }
inline Lanes Sqrt(Lanes a) { return _mm256_sqrt_ps(a.v); }
inline Lanes Floor(Lanes a) { return _mm256_floor_ps(a.v); }
inline Lanes Round(Lanes a) { return _mm256_round_ps(a.v, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC); }
inline Lanes Abs(Lanes a) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), a.v); }
inline Lanes Mix(Lanes a, Lanes b, Lanes share) { return a + (b - a) * share; }
inline __m256i ToInt(Lanes a) { return _mm256_cvttps_epi32(a.v); }
inline Lanes Gather(const float* table, __m256i index) { return _mm256_i32gather_ps(table, index, 4); }
inline Mask GatherMask(const int* table, __m256i index) {
  const __m256i zero = _mm256_cmpeq_epi32(_mm256_i32gather_epi32(table, index, 4), _mm256_setzero_si256());
  return {_mm256_castsi256_ps(_mm256_xor_si256(zero, _mm256_set1_epi32(-1)))};
}

/// Angle of (x, y), to within 5e-7 rad: an odd polynomial through the Chebyshev nodes of [0, 1].
inline Lanes Atan2(Lanes y, Lanes x) {
  const Lanes ax = Abs(x), ay = Abs(y);
  const Lanes t = Min(ax, ay) / Max(Max(ax, ay), 1e-30f), s = t * t;
  Lanes p = 0.007648353926762766f;
  for (const float c : {-0.03636043085731773f, 0.08312645300619582f, -0.13447864058090495f,
                        0.19872040268214597f, -0.33325678039723927f, 0.9999992255890977f})
    p = p * s + c;
  p = p * t;
  p = Select(ay > ax, Lanes(1.57079632679f) - p, p);
  p = Select(x < 0.0f, Lanes(3.14159265359f) - p, p);
  return _mm256_or_ps(p.v, _mm256_and_ps(y.v, _mm256_set1_ps(-0.0f)));
}

}  // namespace citrine::fusion

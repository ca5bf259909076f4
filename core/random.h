#pragma once

#include <cmath>
#include <cstdint>
#include <span>

namespace citrine {

/// PCG32 (O'Neill 2014): the project's only source of randomness, so that a seed means the same everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0) : increment_((stream << 1) | 1) {
    Next();
    state_ += seed;
    Next();
  }

  std::uint32_t Next() {
    const std::uint64_t old = state_;
    state_ = old * kMultiplier + increment_;
    const auto xorshifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
    const auto rot = static_cast<std::uint32_t>(old >> 59);
    return (xorshifted >> rot) | (xorshifted << ((32 - rot) & 31));
  }

  /// Passes over the next n numbers, in as many steps as n has digits (Brown 1994).
  void Advance(std::uint64_t n) {
    std::uint64_t multiplier = kMultiplier, increment = increment_, all_multiplier = 1, all_increment = 0;
    for (; n > 0; n >>= 1) {
      if (n & 1) {
        all_multiplier *= multiplier;
        all_increment = all_increment * multiplier + increment;
      }
      increment *= multiplier + 1;
      multiplier *= multiplier;
    }
    state_ = all_multiplier * state_ + all_increment;
  }

  /// In [0, 1).
  double Uniform() { return Next() * 0x1p-32; }
  double Uniform(double min, double max) { return min + (max - min) * Uniform(); }
  /// In [0, n).
  std::uint32_t Below(std::uint32_t n) {
    return static_cast<std::uint32_t>((static_cast<std::uint64_t>(Next()) * n) >> 32);
  }

  /// Standard normal (Box & Muller 1958, one of the pair). Takes kNumbersOfNormal numbers.
  static constexpr int kNumbersOfNormal = 2;
  double Normal() {
    const double u = (Next() + 1.0) * 0x1p-32;
    return std::sqrt(-2 * std::log(u)) * std::cos(6.283185307179586 * Uniform());
  }
  /// As many calls of Normal() would give the same but for their last bits, in a tenth of the time.
  void Normals(std::span<double> normals);

 private:
  static constexpr std::uint64_t kMultiplier = 6364136223846793005ULL;
  std::uint64_t state_ = 0;
  std::uint64_t increment_;
};

}  // namespace citrine

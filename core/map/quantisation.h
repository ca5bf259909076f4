#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace citrine {

inline constexpr std::uint8_t kUnknownCode = 0;  ///< distance code of a voxel that was never observed
inline constexpr std::uint8_t kFreeCode = 255;   ///< distance code of +T: nothing within the truncation

/// Codes of one voxel on the wire. Every decision of the system, the base station's too, is made on these.
///
/// Distance: 0 unknown; 1..255 the signed distance -T..+T in steps of T/127 (error at most T/254). Codes at
/// or above that of +T are the one class "free". Weight: 0 none; 1..255 logarithmic, 255 at `weight_max`
/// (largest w*), a factor of 1.02 a step (error at most 1 %); w >= 0.9999 w* always decodes as reached.
class Quantisation {
 public:
  Quantisation() = default;
  Quantisation(double truncation_m, double weight_max)
      : truncation_m_(truncation_m), weight_max_(weight_max) {}

  std::uint8_t DistanceCode(double distance_m) const {
    const double x = std::clamp(distance_m / truncation_m_, -1.0, 1.0);
    return static_cast<std::uint8_t>(128 + std::lround(x * 127));
  }
  double Distance(std::uint8_t code) const { return (static_cast<int>(code) - 128) / 127.0 * truncation_m_; }

  std::uint8_t WeightCode(double weight) const {
    if (!(weight > 0)) return 0;
    if (weight >= 0.9999 * weight_max_) return 255;
    // Rounded down, so that nothing short of the goal ever decodes as having reached it.
    const double steps = std::floor(std::log(weight / weight_max_) / kLogStep);
    return static_cast<std::uint8_t>(std::clamp(255.0 + steps, 1.0, 254.0));
  }
  double Weight(std::uint8_t code) const {
    return code == 0 ? 0.0 : weight_max_ * std::exp((static_cast<int>(code) - 255) * kLogStep);
  }

  double truncation_m() const { return truncation_m_; }
  double weight_max() const { return weight_max_; }

 private:
  static constexpr double kLogStep =
      0.01980262729617973;  // ln 1.02: 254 steps reach 1/150 of the top, 55 m at 4.5 m
  double truncation_m_ = 0.5;
  double weight_max_ = 1.0 / (4.5 * 4.5);
};

}  // namespace citrine

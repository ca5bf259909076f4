#pragma once

#include <algorithm>
#include <cmath>

namespace citrine {

/// Confidence of one measurement at a range [m] (paper, IV-A, after Nguyen et al. 2012).
inline double Confidence(double range_m) { return 1.0 / (range_m * range_m); }

/// d*: the distance from which one look reaches confidence w* (eq. 5) [m].
inline double ReferenceDistance(double w_star, double range_max_m) {
  return std::min(std::sqrt(1.0 / w_star), range_max_m);
}

/// A weight this close to its goal counts as having reached it (design, section 6).
inline constexpr double kReached = 0.9999;

}  // namespace citrine

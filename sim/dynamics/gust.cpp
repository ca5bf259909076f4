#include "sim/dynamics/gust.h"

#include <cmath>

namespace citrine::sim {

namespace {
constexpr double kCorrelation_s = 1.5;
}

Gust::Gust(double peak_mps, std::uint64_t seed, std::uint64_t stream)
    : peak_mps_(peak_mps), random_(seed, stream) {}

void Gust::Step(double dt_s) {
  if (peak_mps_ <= 0) return;
  const double keep = std::exp(-dt_s / kCorrelation_s);
  const double sigma_mps = peak_mps_ / 3 * std::sqrt(1 - keep * keep);
  for (int axis = 0; axis < 3; ++axis) {
    const double share = axis == 2 ? 0.5 : 1.0;
    filtered_(axis) = keep * filtered_(axis) + share * sigma_mps * random_.Normal();
  }
  const double speed_mps = filtered_.norm();
  velocity_W_ = speed_mps > peak_mps_ ? Eigen::Vector3d(filtered_ * (peak_mps_ / speed_mps)) : filtered_;
}

}  // namespace citrine::sim

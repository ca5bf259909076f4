#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "core/random.h"

namespace citrine::sim {

/// Seeded gusts at one UAV: white noise through a first-order filter on each axis, as Dryden's longitudinal
/// spectrum at low airspeed. Standard deviation a third of the peak, vertically half of that; never beyond
/// the peak.
class Gust {
 public:
  /// @param peak_mps 0: calm  @param stream one a UAV
  Gust(double peak_mps, std::uint64_t seed, std::uint64_t stream);

  void Step(double dt_s);

  /// [m/s] of the air in the world.
  const Eigen::Vector3d& velocity_W() const { return velocity_W_; }

 private:
  double peak_mps_;
  Random random_;
  Eigen::Vector3d filtered_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d velocity_W_ = Eigen::Vector3d::Zero();
};

}  // namespace citrine::sim

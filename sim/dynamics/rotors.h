#pragma once

#include "sim/dynamics/quadrotor_model.h"

namespace citrine::sim {

/// Four rotors whose speeds follow what is commanded with a first-order lag.
class Rotors {
 public:
  /// Begins at the speed that carries the weight.
  explicit Rotors(const QuadrotorModel& model);

  /// Advances by `dt_s` towards the commanded thrusts [N], each clamped to what a rotor can do.
  void Step(const Eigen::Vector4d& commanded_N, double dt_s);

  /// [N] along body z, one a rotor.
  Eigen::Vector4d thrusts_N() const { return model_.thrust_coefficient * speed_radps_.cwiseAbs2(); }

 private:
  QuadrotorModel model_;
  Eigen::Vector4d speed_radps_;
};

}  // namespace citrine::sim

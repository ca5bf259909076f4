#include "sim/dynamics/rotors.h"

#include <algorithm>
#include <cmath>

namespace citrine::sim {

Rotors::Rotors(const QuadrotorModel& model) : model_(model) {
  const double hover_N = model.mass_kg * kGravity_mps2 / 4;
  speed_radps_.setConstant(std::sqrt(hover_N / model.thrust_coefficient));
}

void Rotors::Step(const Eigen::Vector4d& commanded_N, double dt_s) {
  for (int i = 0; i < 4; ++i) {
    const double thrust_N = std::clamp(commanded_N(i), 0.0, model_.rotor_thrust_max_N());
    const double target_radps = std::sqrt(thrust_N / model_.thrust_coefficient);
    const double tau_s = target_radps > speed_radps_(i) ? model_.spin_up_s : model_.spin_down_s;
    speed_radps_(i) += (target_radps - speed_radps_(i)) * (1 - std::exp(-dt_s / tau_s));
  }
}

}  // namespace citrine::sim

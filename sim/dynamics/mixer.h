#pragma once

#include "sim/dynamics/quadrotor_model.h"

namespace citrine::sim {

/// Force along body z [N] and torque in the body frame [N m].
struct Wrench {
  double thrust_N = 0;
  Eigen::Vector3d torque_B = Eigen::Vector3d::Zero();
};

/// The wrench that four rotor thrusts exert about the centre of mass.
Wrench WrenchOf(const QuadrotorModel& model, const Eigen::Vector4d& thrusts_N);

/// Rotor thrusts that exert a wrench. Where the rotors cannot, roll and pitch come first, then yaw gives way,
/// then the collective thrust moves into what is left. @return thrusts within [0, rotor_thrust_max_N]
Eigen::Vector4d Mix(const QuadrotorModel& model, const Wrench& wrench);

}  // namespace citrine::sim

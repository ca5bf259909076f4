#include "sim/dynamics/mixer.h"

#include <algorithm>

#include <Eigen/LU>

namespace citrine::sim {

namespace {

/// Rows: thrust, torque x, y, z; columns: rotors.
Eigen::Matrix4d Allocation(const QuadrotorModel& model) {
  Eigen::Matrix4d allocation;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Vector3d& p = model.rotor_p_B[i];
    allocation.col(i) << 1, p.y(), -p.x(), model.rotor_spin[i] * model.torque_per_thrust_m;
  }
  return allocation;
}

double Range(const Eigen::Vector4d& x) { return x.maxCoeff() - x.minCoeff(); }

}  // namespace

Wrench WrenchOf(const QuadrotorModel& model, const Eigen::Vector4d& thrusts_N) {
  const Eigen::Vector4d wrench = Allocation(model) * thrusts_N;
  return {wrench(0), wrench.tail<3>()};
}

Eigen::Vector4d Mix(const QuadrotorModel& model, const Wrench& wrench) {
  const double max_N = model.rotor_thrust_max_N();
  const Eigen::Matrix4d inverse = Allocation(model).inverse();

  Eigen::Vector4d differences = inverse.middleCols<2>(1) * wrench.torque_B.head<2>();
  if (Range(differences) > max_N) differences *= max_N / Range(differences);

  const Eigen::Vector4d yaw = inverse.col(3) * wrench.torque_B.z();
  const double room_N = max_N - Range(differences);
  differences += Range(yaw) > room_N ? Eigen::Vector4d(yaw * (room_N / Range(yaw))) : yaw;

  const double lowest_N = -differences.minCoeff();
  const double highest_N = std::max(lowest_N, max_N - differences.maxCoeff());
  const double collective_N = std::clamp(wrench.thrust_N / 4, lowest_N, highest_N);
  return (differences.array() + collective_N).cwiseMax(0).cwiseMin(max_N);
}

}  // namespace citrine::sim

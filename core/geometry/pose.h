#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace citrine {

/// X_AB: where frame B stands in frame A. Composes as X_AC = X_AB * X_BC and maps points as p_A = X_AB * p_B.
struct Pose {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();            ///< [m] origin of B in A
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();  ///< axes of B in A

  Eigen::Vector3d operator*(const Eigen::Vector3d& p_B) const { return p + q * p_B; }
  Pose operator*(const Pose& X_BC) const { return {p + q * X_BC.p, q * X_BC.q}; }
  Pose Inverse() const { return {q.conjugate() * -p, q.conjugate()}; }
};

/// Rotation about z that is nearest to the frame's x axis [rad].
inline double YawOf(const Eigen::Quaterniond& q) {
  const Eigen::Vector3d x = q * Eigen::Vector3d::UnitX();
  return std::atan2(x.y(), x.x());
}

/// `angle_rad` wrapped into (-pi, pi].
inline double WrapAngle(double angle_rad) { return std::remainder(angle_rad, 2 * EIGEN_PI); }

}  // namespace citrine

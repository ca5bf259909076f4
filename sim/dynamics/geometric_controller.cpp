#include "sim/dynamics/geometric_controller.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace citrine::sim {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kPositionErrorMax_m = 1.0;
constexpr double kVelocityErrorMax_mps = 5.0;

Vector3d Shortened(const Vector3d& x, double length) {
  return x.norm() > length ? Vector3d(x.normalized() * length) : x;
}

Vector3d Vee(const Matrix3d& skew) { return {skew(2, 1), skew(0, 2), skew(1, 0)}; }

/// A specific force that keeps the rotors pulling up and leans no further than `tilt_max_rad`.
Vector3d LimitTilt(Vector3d force, double tilt_max_rad) {
  force.z() = std::max(force.z(), 0.2 * kGravity_mps2);
  const double sideways_max = force.z() * std::tan(tilt_max_rad);
  const double sideways = force.head<2>().norm();
  if (sideways > sideways_max) force.head<2>() *= sideways_max / sideways;
  return force;
}

/// Attitude whose z axis points along `b3` and whose x axis heads as near to `yaw_rad` as that allows (eq.
/// 23).
Matrix3d AttitudeOf(const Vector3d& b3, double yaw_rad) {
  const Vector3d heading(std::cos(yaw_rad), std::sin(yaw_rad), 0);
  Matrix3d R;
  R.col(2) = b3;
  R.col(1) = b3.cross(heading).normalized();
  R.col(0) = R.col(1).cross(b3);
  return R;
}

/// What a thrust that changes at a rate has to be ahead of its reference, for rotors that follow with a lag.
double RotorLead(const QuadrotorModel& model, double rate) {
  return rate * (rate > 0 ? model.spin_up_s : model.spin_down_s);
}

}  // namespace

Wrench TrackOnSE3(const QuadrotorModel& model, const ControllerGains& gains, const UavState& state,
                  const TrajectoryPoint& reference, const Vector3d& snap_W) {
  const Vector3d e_x = Shortened(state.X_WB.p - reference.p_W, kPositionErrorMax_m);
  const Vector3d e_v = Shortened(state.v_W - reference.v_W, kVelocityErrorMax_mps);
  const double k_x = gains.position_radps * gains.position_radps;
  const double k_v = 2 * gains.position_damping * gains.position_radps;

  // Everything per mass: the specific force that the rotors shall give, and how it changes along the
  // reference.
  const Vector3d gravity(0, 0, kGravity_mps2);
  const Vector3d force = LimitTilt(
      reference.a_W + model.drag_per_s * reference.v_W + gravity - k_x * e_x - k_v * e_v, gains.tilt_max_rad);
  const Vector3d force_rate = reference.j_W + model.drag_per_s * reference.a_W;
  const Vector3d force_curve = snap_W + model.drag_per_s * reference.j_W;

  const Vector3d b3 = force.normalized();
  const Matrix3d R_c = AttitudeOf(b3, reference.yaw_rad);
  const double growth = force_rate.dot(b3);
  const Vector3d b3_rate = (force_rate - growth * b3) / force.norm();
  const Vector3d omega_c(-R_c.col(1).dot(b3_rate), R_c.col(0).dot(b3_rate),
                         reference.yaw_rate_radps * b3.z());
  // But for what lies along b3, which turns nothing: b3'' = (f'' - 2 |f|' b3') / |f| is also
  // R_c (alpha x e3 + omega x (omega x e3)).
  const Vector3d b3_curve = (force_curve - 2 * growth * b3_rate) / force.norm();
  const Vector3d alpha_c(-R_c.col(1).dot(b3_curve) + omega_c.z() * omega_c.y(),
                         R_c.col(0).dot(b3_curve) - omega_c.z() * omega_c.x(), 0);

  const Matrix3d R = state.X_WB.q.toRotationMatrix();
  const Vector3d e_R = 0.5 * Vee(R_c.transpose() * R - R.transpose() * R_c);
  const Matrix3d R_e = R.transpose() * R_c;
  const Vector3d omega_c_B = R_e * omega_c;
  const Vector3d e_omega = state.omega_B - omega_c_B;

  const Vector3d frequency(gains.attitude_radps, gains.attitude_radps, gains.yaw_radps);
  const Vector3d damping(gains.attitude_damping, gains.attitude_damping, gains.yaw_damping);
  const Vector3d k_R = frequency.cwiseAbs2();
  const Vector3d k_omega = 2 * damping.cwiseProduct(frequency);
  const Vector3d& J = model.inertia_kgm2;
  const Vector3d& omega = state.omega_B;

  Wrench wrench;
  wrench.thrust_N =
      std::max(0.0, model.mass_kg * (force.dot(R.col(2)) + RotorLead(model, force_rate.dot(R.col(2)))));
  wrench.torque_B = J.cwiseProduct(-k_R.cwiseProduct(e_R) - k_omega.cwiseProduct(e_omega) -
                                   omega.cross(omega_c_B) + R_e * alpha_c) +
                    omega.cross(J.cwiseProduct(omega));
  return wrench;
}

}  // namespace citrine::sim

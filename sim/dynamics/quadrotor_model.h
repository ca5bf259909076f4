#pragma once

#include <array>

#include <Eigen/Core>

namespace citrine::sim {

/// Rigid body, rotors and drag of a quadrotor. Body frame: x forward, y left, z up, origin in the centre of
/// mass.
///
/// The defaults are of the Intel Aero's class, not a model identified on that vehicle: each number says
/// whether it is the airframe's, another vehicle's, or our choice.
struct QuadrotorModel {
  /// [kg] rounded up from the 1.38 that flight software for this airframe is configured with.
  double mass_kg = 1.4;

  /// [kg m^2] four motors with propeller and arm end (85 g each, 0.127 m off both axes), and the
  /// remaining 1.06 kg as a box of 0.14 x 0.14 x 0.10 m: our estimate.
  Eigen::Vector3d inertia_kgm2{0.0081, 0.0081, 0.0145};

  /// [m] rotor positions: front left, back right, front right, back left. Nominally 0.36 m between opposite
  /// motors, not checked against the maker's drawing; their height is our choice.
  std::array<Eigen::Vector3d, 4> rotor_p_B{
      Eigen::Vector3d{0.127, 0.127, 0.03}, Eigen::Vector3d{-0.127, -0.127, 0.03},
      Eigen::Vector3d{0.127, -0.127, 0.03}, Eigen::Vector3d{-0.127, 0.127, 0.03}};
  /// Sign of the torque about body z that a rotor's drag exerts.
  std::array<double, 4> rotor_spin{-1, -1, 1, 1};

  /// [N s^2] thrust = this * speed^2; [rad/s] largest speed; together 7.1 N a rotor, a thrust-to-weight ratio
  /// of 2.06. Both are the Iris's, a vehicle of about this mass, in Gazebo. The Aero itself is weaker: the
  /// thrust curve in the software above ends near 19 N, 1.4 times its weight, which leaves nothing to spare
  /// at the paper's 4.8 m/s^2.
  double thrust_coefficient = 5.84e-6;
  double rotor_speed_max_radps = 1100;

  /// [m] drag torque per thrust (the same source).
  double torque_per_thrust_m = 0.06;

  /// [s] time constants of a rotor's speed, faster and slower (the same source).
  double spin_up_s = 0.0125;
  double spin_down_s = 0.025;

  /// [1/s] deceleration per airspeed by rotor drag, alike on all axes: our choice, of the size that Faessler
  /// et al. (2018) identify for a smaller quadrotor.
  double drag_per_s = 0.465;

  double rotor_thrust_max_N() const {
    return thrust_coefficient * rotor_speed_max_radps * rotor_speed_max_radps;
  }
  double thrust_max_N() const { return 4 * rotor_thrust_max_N(); }
};

inline constexpr double kGravity_mps2 = 9.80665;

}  // namespace citrine::sim

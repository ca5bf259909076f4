#pragma once

#include <array>

#include <Eigen/Core>

namespace citrine::sim {

/// Rigid body, rotors and drag of a quadrotor. Body frame: x forward, y left, z up, origin in the centre of mass.
///
/// The defaults are an Intel Aero with a small LiDAR. Geometry is the data sheet's; what it does not give is taken from
/// vehicles of the same class, as said at each number.
struct QuadrotorModel {
  /// [kg] 1.38 was weighed by a group that flies this airframe with battery and computer; rounded up.
  double mass_kg = 1.4;

  /// [kg m^2] four motors with propeller and arm end (85 g each, 0.127 m off both axes), and the remaining 1.06 kg as a box
  /// of 0.14 x 0.14 x 0.10 m: our estimate.
  Eigen::Vector3d inertia_kgm2{0.0081, 0.0081, 0.0145};

  /// [m] rotor positions, 0.36 m between opposite motors (data sheet): front left, back right, front right, back left.
  std::array<Eigen::Vector3d, 4> rotor_p_B{Eigen::Vector3d{0.127, 0.127, 0.03}, Eigen::Vector3d{-0.127, -0.127, 0.03},
                                           Eigen::Vector3d{0.127, -0.127, 0.03}, Eigen::Vector3d{-0.127, 0.127, 0.03}};
  /// Sign of the torque about body z that a rotor's drag exerts.
  std::array<double, 4> rotor_spin{-1, -1, 1, 1};

  /// [N s^2] thrust = this * speed^2; [rad/s] largest speed; together 7.1 N a rotor, a thrust-to-weight ratio of 2.06.
  /// Both are those of the Iris, of the same mass and propeller size, in PX4's Gazebo models.
  double thrust_coefficient = 5.84e-6;
  double rotor_speed_max_radps = 1100;

  /// [m] drag torque per thrust (the same source).
  double torque_per_thrust_m = 0.06;

  /// [s] time constants of a rotor's speed, faster and slower (the same source, and RotorS; Furrer et al. 2016).
  double spin_up_s = 0.0125;
  double spin_down_s = 0.025;

  /// [1/s] deceleration per airspeed by rotor drag: the mean of 0.544 and 0.386 identified by Faessler et al. (2018).
  double drag_per_s = 0.465;

  double rotor_thrust_max_N() const { return thrust_coefficient * rotor_speed_max_radps * rotor_speed_max_radps; }
  double thrust_max_N() const { return 4 * rotor_thrust_max_N(); }
};

inline constexpr double kGravity_mps2 = 9.80665;

}  // namespace citrine::sim

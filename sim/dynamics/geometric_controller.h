#pragma once

#include "core/trajectory/trajectory.h"
#include "core/vehicle/uav_state.h"
#include "sim/dynamics/mixer.h"
#include "sim/dynamics/quadrotor_model.h"

namespace citrine::sim {

/// Gains of the tracking controller as frequency and damping of each loop's linear error dynamics.
struct ControllerGains {
  double position_radps = 4.0, position_damping = 0.9;
  double attitude_radps = 25.0, attitude_damping = 1.0;
  double yaw_radps = 6.0, yaw_damping = 1.0;
  double tilt_max_rad = 1.05;  ///< far from its reference a UAV leans this far at most
};

/// Geometric tracking control on SE(3) (Lee, Leok & McClamroch 2010), eqs. 19, 20 and 23, with the
/// reference's drag fed forward (Faessler et al. 2018), the reference's body rate taken from its jerk, its
/// angular acceleration from its snap, and the thrust ahead of it by the lag of the rotors. Far from the
/// reference the position error is shortened to 1 m.
/// @param snap_W [m/s^4] how the reference's jerk changes; the yaw's rate counts as steady
Wrench TrackOnSE3(const QuadrotorModel& model, const ControllerGains& gains, const UavState& state,
                  const TrajectoryPoint& reference, const Eigen::Vector3d& snap_W);

}  // namespace citrine::sim

#pragma once

#include <cstdint>
#include <vector>

#include "core/config/mission_config.h"
#include "core/map/tri_mesh.h"
#include "core/time.h"
#include "core/trajectory/trajectory.h"
#include "core/vehicle/uav_state.h"
#include "sim/dynamics/contact_counter.h"
#include "sim/dynamics/geometric_controller.h"
#include "sim/dynamics/gust.h"
#include "sim/dynamics/rigid_bodies.h"
#include "sim/dynamics/rotors.h"
#include "sim/dynamics/trajectory_queue.h"

namespace citrine::sim {

/// A fleet of quadrotors that fly the trajectories they are given: rotors with lag and limits, linear drag,
/// gusts, contacts with the world and each other. UAVs are numbered 1..N. Same seed, same calls: same bits.
class FleetSimulator {
 public:
  /// Each UAV begins hovering at its spawn at mission time 0, heading along x.
  /// @throws ConfigError if dynamics.step_s / dynamics.substeps is above 5 ms, too coarse for the attitude
  /// loop
  FleetSimulator(const TriMesh& world, const std::vector<Eigen::Vector3d>& spawns_W, const UavSection& uav,
                 const DynamicsSection& dynamics, std::uint64_t seed, const QuadrotorModel& model = {});

  /// From trajectory.start on, `uav` flies it; until then the one before; after its end it hovers there.
  void Follow(int uav, Trajectory trajectory);

  /// Advances from `now` by `dt_s`.
  void Step(Utime now, double dt_s);

  int uavs() const { return static_cast<int>(vehicles_.size()); }
  /// The true state at the end of the last step.
  const UavState& state(int uav) const { return vehicles_[static_cast<std::size_t>(uav - 1)].state; }
  /// [N] what the four rotors give at the end of the last step.
  Eigen::Vector4d rotor_thrusts_N(int uav) const {
    return vehicles_[static_cast<std::size_t>(uav - 1)].rotors.thrusts_N();
  }

 private:
  struct Vehicle {
    UavState state;
    Rotors rotors;
    Gust gust;
    TrajectoryQueue queue;
  };

  void Substep(Utime now, double dt_s);

  QuadrotorModel model_;
  ControllerGains gains_;
  double substep_s_;
  RigidBodies bodies_;
  ContactCounter contacts_;
  std::vector<Vehicle> vehicles_;
};

}  // namespace citrine::sim

#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/map/tri_mesh.h"
#include "core/vehicle/uav_state.h"
#include "sim/dynamics/mixer.h"
#include "sim/dynamics/quadrotor_model.h"

namespace citrine::sim {

/// Two that touch: a body (numbered from 0) and another body or, as kWorld, the world.
struct Touch {
  static constexpr int kWorld = -1;
  int body = 0;
  int other = kWorld;
};

/// Airframes as spheres of kAirframeRadius_m under gravity, and a world of triangles that are solid from both
/// sides, in the Open Dynamics Engine. One thread; the same calls give the same bits.
class RigidBodies {
 public:
  RigidBodies(const TriMesh& world, const QuadrotorModel& model, const std::vector<Eigen::Vector3d>& p_W,
              std::uint64_t seed);
  ~RigidBodies();

  /// Exerts a wrench in the body frame and a force in the world frame [N] during the next step.
  void Exert(int body, const Wrench& wrench_B, const Eigen::Vector3d& force_W);

  /// Advances by `dt_s`. @return who touched whom, each pair once
  std::vector<Touch> Step(double dt_s);

  /// Pose, velocity and body rate; time and contacts are left to the caller.
  UavState state(int body) const;

  /// Places a body with a velocity.
  void Place(int body, const Pose& X_WB, const Eigen::Vector3d& v_W);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace citrine::sim

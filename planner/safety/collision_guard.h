#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/sensor/lidar_scan.h"
#include "planner/trajectory/trajectory_check.h"

namespace citrine::planner {

/// What the guard wants done about the committed trajectory, and why.
struct GuardVerdict {
  enum class Action { kOk, kBrake, kYield };
  Action action = Action::kOk;
  Utime at = 0;  ///< when it would happen
  std::string why;
};

/// The 20 Hz collision checker (paper, IV-E): a box in the direction of travel, its length proportional to
/// what speed asks for stopping, against the newest scan; and the teammates' committed trajectories, compared
/// in time.
class CollisionGuard {
 public:
  CollisionGuard(int uav, const VehicleLimits& limits) : uav_(uav), limits_(limits) {}

  /// Keeps the hits of a scan, in the world frame, up to the longest box.
  void HearScan(const LidarScan& scan);

  GuardVerdict Check(const Trajectory& committed, Utime now, const FlightScene& scene) const;

  /// When a trajectory would come too close to a hit in the box. nullopt: it does not within the horizon, or
  /// not before it could stop if that is longer
  std::optional<Utime> FindHit(const Trajectory& committed, Utime now, const FlightScene& scene,
                               double horizon_s = 1.5) const;
  /// Conflicts that this UAV has to solve: with a lower id, with one that stands still and cannot, or one
  /// that nobody has solved in time.
  std::optional<Violation> FindConflictToSolve(const Trajectory& committed, Utime now,
                                               const FlightScene& scene) const;

  /// [m] length of the box at a speed: radius + reaction + stopping distance.
  double BoxLength(double speed_mps) const;

 private:
  int uav_;
  VehicleLimits limits_;
  LidarModel model_;
  std::vector<Eigen::Vector3f> directions_;  ///< of the model's beams
  std::vector<Eigen::Vector3d> hits_W_;
  Utime measured_ = -1;
};

}  // namespace citrine::planner

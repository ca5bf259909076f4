#pragma once

#include <array>
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

  void HearScan(LidarScan scan);

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
  /// What lies at most a radius beside a line from where a UAV is to where it goes.
  struct Box {
    Eigen::Vector3d from_W, ahead_W;  ///< the latter of unit length
    double length_m, radius_m;
  };
  /// Beams of the newest scan that hit something in a box or a centimetre beside it, ascending.
  std::vector<std::size_t> BeamsInto(const Box& box) const;
  /// The hits in it [m].
  std::vector<Eigen::Vector3d> HitsIn(const Box& box) const;

  int uav_;
  VehicleLimits limits_;
  std::optional<LidarScan> scan_;                   ///< the newest
  std::array<std::vector<float>, 3> directions_S_;  ///< of its beams, by axis
};

}  // namespace citrine::planner

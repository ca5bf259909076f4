#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/fleet/fleet_status.h"
#include "core/sensor/lidar_scan.h"
#include "core/trajectory/path.h"
#include "core/trajectory/trajectory.h"
#include "core/vehicle/uav_state.h"
#include "planner/safety/collision_guard.h"
#include "planner/safety/flight_planner.h"

namespace citrine::planner {

struct FlightSettings {
  int uav = 1;
  VehicleLimits limits;
  double path_margin_m = 0.1;
  FlightWeights weights;
  double replan_ahead_s = 0.12;
  double guard_hz = 20;
};

/// Flies one UAV: keeps one committed trajectory that always ends at rest in known free space, and replaces
/// it only by another such one that continues it exactly. Nouns in, nouns out: Hear...() what arrives, then
/// Act() once a step.
///
/// A new path is smoothed at once, without stopping between goals; where it leads through the end of the one
/// before, so does the motion. What is committed is checked again when the map changes and by the guard; if
/// it is no longer good: another trajectory to the same goal, else brake along it, else brake straight. A
/// path that cannot be flown is tried again every half second and reported kBlocked after three failures.
class FlightExecutive {
 public:
  /// @param map outlives it
  FlightExecutive(const FlightSettings& settings, const PlanningMap& map, SolveMotion solve);

  void HearPath(const Path& path);        ///< the newest; an id that is known is ignored
  void HearState(const UavState& state);  ///< its own; the first at rest says where it hovers
  void HearScan(LidarScan scan) { guard_.HearScan(std::move(scan)); }
  void HearTeammate(int uav, const Trajectory& trajectory);  ///< its committed one
  void HearTeammate(int uav, const UavState& state);  ///< where it hovers, until its trajectory is known

  /// @param map_changed whether the map has changed since the last call
  void Act(Utime now, bool map_changed);

  /// nullopt before the first state of its own.
  const std::optional<Trajectory>& committed() const { return committed_; }
  FlightStatus Status(Utime now) const;
  /// Whether the last Act() tried to plan.
  bool planned() const { return planned_; }

 private:
  bool Replan(Utime now);
  void Retry(Utime now);
  void Brake(Utime now, const std::string& why);
  void React(Utime now, const std::string& why);
  void Commit(Trajectory trajectory, bool braking);
  void CountFailure(Utime now);
  bool AtRest(Utime now) const { return committed_->end() <= now; }
  bool PathFinished(Utime now) const;
  bool HeadsForPathEnd() const;
  /// Whether the committed motion looks from the place to be passed between two instants.
  bool Passes(Utime from, Utime to) const;
  /// How near a motion comes to what is occupied or unknown, or to a teammate beyond the radius [m].
  double LeastClearance(const Trajectory& trajectory, Utime from) const;

  FlightSettings settings_;
  FlightPlanner planner_;
  CollisionGuard guard_;
  FlightScene scene_;
  Every guard_due_;
  std::optional<Trajectory> committed_;
  bool braking_ = false;                   ///< the committed trajectory is a brake
  Path path_;                              ///< the newest
  std::optional<Eigen::Vector3d> pass_W_;  ///< the former path's end that is still to be passed
  bool path_is_new_ = false;
  bool has_path_ = false;
  int failures_ = 0;
  Utime retry_at_ = 0;
  Utime waiting_since_ = -1;  ///< at rest short of the path's end
  bool blocked_ = false;
  std::string reason_;
  std::int64_t trajectories_ = 0;
  bool planned_ = false;
};

}  // namespace citrine::planner

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/map/planning_map.h"
#include "fusion/map_fuser.h"
#include "planner/path/path_search.h"
#include "planner/safety/flight_executive.h"
#include "sim/dynamics/fleet_simulator.h"
#include "sim/lidar/lidar_emulator.h"
#include "tests/soak/soak_world.h"

namespace citrine::soak {

/// The extremes of a flight, of all UAVs together.
struct SoakResult {
  int flights = 0, uavs = 0, arrived = 0, blocked = 0, contacts = 0;
  int plans = 0, failures = 0;                   ///< attempts to plan, and those that brought no trajectory
  double clearance_m = 1e9, separation_m = 1e9;  ///< true, between centre and surface, and centres
  double planned_speed_mps = 0, planned_acceleration_mps2 = 0;  ///< of what was committed
  double flown_speed_mps = 0,
         flown_acceleration_mps2 = 0;  ///< of the vehicles; acceleration as a mean over 0.1 s
  double jump = 0;                     ///< of position, velocity, acceleration between committed trajectories
  double error_m = 0;                  ///< of tracking
  double seconds = 0;                  ///< mission time
  std::vector<double> smoothing_ms, planning_ms;  ///< CPU time of each solve; of each step that planned
  void Add(const SoakResult& other);
};

/// A fleet without a bus that discovers a world as it flies: the executives, the simulated vehicles and
/// LiDARs, and the fused map, said twice a second. Instead of view planners, pilots that want to be at one
/// goal each.
class SoakFlight {
 public:
  SoakFlight(const Scenario& scenario, const UavSection& uav);

  /// Flies until everybody is at its goal or the time is over.
  SoakResult Fly(double time_limit_s);

 private:
  struct Pilot {
    int uav = 0;
    Eigen::Vector3d goal_W = Eigen::Vector3d::Zero(), retreat_W = Eigen::Vector3d::Zero();
    std::unique_ptr<planner::FlightExecutive> executive;
    std::unique_ptr<planner::PathSearch> search;
    std::optional<Path> path;
    Utime retreats_until = -1, asks_at = 0;
    std::int64_t followed = 0;
    std::vector<planner::Ball> dead_ends;       ///< the newest places at which it knew no way on
    double search_ms = 0;                       ///< CPU time of the last search for a way to the goal
    UavState said;                              ///< with localisation noise
    std::vector<Eigen::Vector3d> velocities_W;  ///< of the last steps
  };

  void Scan(bool fused);
  bool SayMap();
  void Ask(Pilot& pilot);
  /// A place at random that can be reached: away from where a pilot is stuck, and the further the more often
  /// it was.
  std::optional<Path> LookElsewhere(Pilot& pilot, const Eigen::Vector3d& from_W);
  void Act(Pilot& pilot, bool map_changed);
  void Measure(Pilot& pilot, const Trajectory& before);
  bool Arrived(const Pilot& pilot) const;

  MissionConfig config_;
  std::shared_ptr<const sim::RayScene> scene_;
  sim::FleetSimulator fleet_;
  sim::LidarEmulator lidar_;
  fusion::MapFuser fuser_;
  PlanningMap map_;
  std::vector<Pilot> pilots_;
  Random noise_, places_;
  Utime now_ = 0;
  SoakResult result_;
};

}  // namespace citrine::soak

#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "planner/safety/flight_executive.h"
#include "tests/planner/path/synthetic_map.h"

namespace citrine::planner {

inline SolveMotion PlainSolve() {
  return [smoother = Smoother(200)](const FlightScene& scene, const FlightWeights& weights,
                                    const SmoothingTask& task, const SmoothingResult* warm) {
    return smoother.Solve(scene, weights, task, warm);
  };
}

/// Executives of a fleet without a bus: every 20 ms each acts on what the others had said a step before, and
/// every UAV is exactly where its trajectory has it. Records the extremes of the flight.
class FleetFlight {
 public:
  FleetFlight(const PlanningMap& map, const std::vector<Eigen::Vector3d>& spawns_W,
              SolveMotion solve = PlainSolve())
      : map_(map) {
    for (std::size_t i = 0; i < spawns_W.size(); ++i) {
      FlightSettings settings;
      settings.uav = static_cast<int>(i) + 1;
      executives_.push_back(std::make_unique<FlightExecutive>(settings, map, solve));
      UavState state;
      state.X_WB.p = spawns_W[i];
      executives_[i]->HearState(state);
    }
  }

  FlightExecutive& uav(int id) { return *executives_[static_cast<std::size_t>(id - 1)]; }
  FlightStatus status(int id) { return uav(id).Status(now); }

  /// Finds a way on the map and says it.
  bool Send(int id, const Eigen::Vector3d& goal_W) {
    PathSearch search(map_, VehicleLimits{}, 0.1);
    std::optional<Path> path = search.Find(Position(id), goal_W);
    if (!path) return false;
    path->id = ++paths_;
    uav(id).HearPath(*path);
    return true;
  }

  Eigen::Vector3d Position(int id) { return uav(id).committed()->At(now).p_W; }

  void Step(bool map_changed = false) {
    now += 20'000;
    std::vector<Trajectory> said;
    for (const auto& executive : executives_) said.push_back(*executive->committed());
    for (std::size_t i = 0; i < executives_.size(); ++i)
      for (std::size_t k = 0; k < said.size(); ++k)
        if (k != i) executives_[i]->HearTeammate(static_cast<int>(k) + 1, said[k]);
    for (std::size_t i = 0; i < executives_.size(); ++i) {
      executives_[i]->Act(now, map_changed);
      const TrajectoryPoint before = said[i].At(now), after = executives_[i]->committed()->At(now);
      jump = std::max({jump, (before.p_W - after.p_W).norm(), (before.v_W - after.v_W).norm(),
                       (before.a_W - after.a_W).norm()});
      fastest_mps = std::max(fastest_mps, after.v_W.norm());
      hardest_mps2 = std::max(hardest_mps2, after.a_W.norm());
      to_occupied_m = std::min(to_occupied_m, map_.to_occupied().Interpolate(after.p_W));
      to_unknown_m = std::min(to_unknown_m, map_.to_unknown().Interpolate(after.p_W));
      for (std::size_t k = 0; k < i; ++k)
        separation_m = std::min(separation_m, (after.p_W - executives_[k]->committed()->At(now).p_W).norm());
    }
  }

  void Fly(double seconds) {
    for (const Utime end = now + FromSeconds(seconds); now < end;) Step();
  }

  /// Until a UAV's status is of a phase. @return whether it was within the time
  bool FlyUntil(int id, FlightStatus::Phase phase, double seconds) {
    for (const Utime end = now + FromSeconds(seconds); now < end;) {
      Step();
      if (status(id).phase == phase) return true;
    }
    return false;
  }

  Utime now = 0;
  double jump = 0, fastest_mps = 0, hardest_mps2 = 0;
  double to_occupied_m = 1e9, to_unknown_m = 1e9, separation_m = 1e9;

 private:
  const PlanningMap& map_;
  std::vector<std::unique_ptr<FlightExecutive>> executives_;
  std::int64_t paths_ = 0;
};

}  // namespace citrine::planner

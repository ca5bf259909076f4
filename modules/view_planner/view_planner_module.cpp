#include "modules/view_planner/view_planner_module.h"

#include <tuple>

#include "modules/codec/fleet_assignment.h"
#include "modules/codec/fleet_status.h"
#include "modules/codec/flight_status.h"
#include "modules/codec/path.h"
#include "modules/codec/trajectory.h"
#include "modules/codec/uav_state.h"
#include "modules/hear_nouns.h"
#include "modules/map_hearer.h"
#include "modules/runtime/cpu_stopwatch.h"

namespace citrine {

namespace {

constexpr int kStateQueue = 64, kFewQueue = 16;

/// What makes a status worth saying at once.
auto Essence(const FleetStatus& s) {
  return std::tie(s.activity, s.deciding_since, s.has_goal, s.goal_W.x(), s.goal_W.y(), s.goal_W.z(),
                  s.decisions, s.replanning, s.plan_id, s.corrected_selections_left, s.no_view_left);
}

}  // namespace

ViewPlannerModule::ViewPlannerModule(const ModuleContext& context)
    : bus_(context.bus),
      health_(context.health),
      uav_(context.uav),
      map_hearer_(context.map_hearer),
      path_search_(map_hearer_->reachable(), context.config.uav.limits, context.config.planner.path_margin_m),
      planner_(
          context.config, uav_, map_hearer_->map(), map_hearer_->Surface(), map_hearer_->reachable(),
          [this](const auto& start_W, const auto& goal_W, const auto& avoid) {
            return FindPath(start_W, goal_W, avoid);
          },
          [this](const auto& from_W, const auto& to_W) {
            return map_hearer_->topological_grid().LengthsBetween(from_W, to_W);
          }),
      states_(bus_.HearAll(channels::kUavState, kStateQueue)),
      statuses_(bus_.HearAll(channels::kFleetStatus, kStateQueue)),
      assignments_(bus_.Hear(channels::kFleetAssignment, kFewQueue)),
      flights_(bus_.Hear(channels::kFlightStatus, uav_, kFewQueue)),
      trajectories_(bus_.Hear(channels::kTrajectory, uav_, kFewQueue)) {}

std::optional<Path> ViewPlannerModule::FindPath(const Eigen::Vector3d& start_W, const Eigen::Vector3d& goal_W,
                                                const std::vector<PlanningMap::Ball>& avoid) {
  const CpuStopwatch stopwatch(CpuStopwatch::Of::kProcess);
  std::optional<Path> path = path_search_.Find(start_W, goal_W, avoid);
  path_ms_ += stopwatch.ms();
  health_.Sample("path_ms", stopwatch.ms());
  return path;
}

void ViewPlannerModule::HearAll(Utime now) {
  HearNouns(bus_, channels::kUavState, kEveryUav, *states_,
            [&](int uav, const UavState& state, Utime) { planner_.HearState(uav, state, now); });
  HearNouns(bus_, channels::kFleetStatus, kEveryUav, *statuses_,
            [&](int uav, const FleetStatus& status, Utime) { planner_.HearStatus(uav, status, now); });
  HearNouns(bus_, channels::kFleetAssignment, *assignments_,
            [&](const FleetAssignment& assignment, Utime) { planner_.HearAssignment(assignment, now); });
  HearNouns(bus_, channels::kFlightStatus, kEveryUav, *flights_,
            [&](int, const FlightStatus& flight, Utime) { planner_.HearFlight(flight); });
  HearNouns(bus_, channels::kTrajectory, kEveryUav, *trajectories_,
            [&](int, const Trajectory& trajectory, Utime) { planner_.HearTrajectory(trajectory); });
}

void ViewPlannerModule::Tick(const Step& step) {
  const bool map_changed = map_hearer_->Update(step);
  HearAll(step.now);
  if (map_changed) {
    const CpuStopwatch stopwatch(CpuStopwatch::Of::kProcess);
    planner_.HearMap(step.now);
    health_.Sample("hear_map_ms", stopwatch.ms());
  }
  path_ms_ = 0;
  const CpuStopwatch stopwatch(CpuStopwatch::Of::kProcess);
  const planner::ViewPlanner::Outcome outcome = planner_.Tick(step.now, map_hearer_->map_version());
  if (outcome.decided) {
    health_.Sample("replan_ms", stopwatch.ms() - path_ms_);
    health_.Sample("views", static_cast<double>(outcome.views));
    health_.Sample("elements", static_cast<double>(outcome.elements));
    if (outcome.new_path) health_.Sample("decisions", 1);
    if (outcome.corrected) health_.Sample("corrections", 1);
  }
  Say(outcome, step.now);
}

void ViewPlannerModule::Say(const planner::ViewPlanner::Outcome& outcome, Utime now) {
  const FleetStatus status = planner_.Status();
  const bool status_due = status_.Due(now);
  if (status_due || Essence(status) != Essence(said_)) {
    bus_.Publish(channels::kFleetStatus, uav_, Encode(status));
    said_ = status;
  }
  const bool path_due = path_again_.Due(now);
  if (const Path* path = planner_.path(); path && (outcome.new_path || path_due))
    bus_.Publish(channels::kPath, uav_, Encode(*path));
  const bool assignment_due = assignment_again_.Due(now);
  if (const FleetAssignment* own = planner_.assignment(now); own && (outcome.corrected || assignment_due))
    bus_.Publish(channels::kFleetAssignment, Encode(*own));
}

}  // namespace citrine

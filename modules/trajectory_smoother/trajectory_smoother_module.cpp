#include "modules/trajectory_smoother/trajectory_smoother_module.h"

#include <tuple>
#include <utility>

#include "modules/channels.h"
#include "modules/codec/flight_status.h"
#include "modules/codec/lidar_scan.h"
#include "modules/codec/path.h"
#include "modules/codec/trajectory.h"
#include "modules/codec/uav_state.h"
#include "modules/hear_nouns.h"
#include "modules/map_hearer.h"
#include "modules/runtime/cpu_stopwatch.h"

namespace citrine {

namespace {

constexpr int kScanQueue = 4, kPathQueue = 8;

planner::FlightSettings SettingsOf(const MissionConfig& config, int uav) {
  planner::FlightSettings settings;
  settings.uav = uav;
  settings.limits = config.uav.limits;
  settings.path_margin_m = config.planner.path_margin_m;
  settings.weights = planner::FlightWeights(config.smoother);
  settings.replan_ahead_s = config.smoother.replan_ahead_s;
  settings.guard_hz = config.smoother.guard_hz;
  return settings;
}

planner::SolveMotion Measured(const MissionConfig& config, Health& health) {
  return [smoother = planner::Smoother(config.smoother.evaluations_max), &health](
             const planner::FlightScene& scene, const planner::FlightWeights& weights,
             const planner::SmoothingTask& task, const planner::SmoothingResult* warm) {
    const CpuStopwatch stopwatch;
    planner::SmoothingResult result = smoother.Solve(scene, weights, task, warm);
    health.Sample("smoothing_ms", stopwatch.ms());
    return result;
  };
}

auto Essence(const FlightStatus& status) {
  return std::tie(status.phase, status.path_id, status.trajectory_id, status.failures, status.reason);
}

}  // namespace

TrajectorySmootherModule::TrajectorySmootherModule(const ModuleContext& context)
    : bus_(context.bus),
      health_(context.health),
      uav_(context.uav),
      map_hearer_(context.map_hearer),
      executive_(SettingsOf(context.config, context.uav), map_hearer_->map(),
                 Measured(context.config, context.health)),
      paths_(bus_.Hear(channels::kPath, uav_, kPathQueue)),
      scans_(bus_.Hear(channels::kLidarScan, uav_, kScanQueue)),
      states_(bus_.HearAll(channels::kUavState)),
      trajectories_(bus_.HearAll(channels::kTrajectory)) {}

void TrajectorySmootherModule::Tick(const Step& step) {
  const bool map_changed = map_hearer_->Update(step);
  HearAll();
  const CpuStopwatch stopwatch;
  executive_.Act(step.now, map_changed);
  if (executive_.planned()) health_.Sample("smooth_plan_ms", stopwatch.ms());
  SayTrajectory(step.now);
  SayStatus(step.now);
}

void TrajectorySmootherModule::HearAll() {
  HearNouns(bus_, channels::kUavState, kEveryUav, *states_, [this](int uav, const UavState& state, Utime) {
    if (uav == uav_)
      executive_.HearState(state);
    else
      executive_.HearTeammate(uav, state);
  });
  HearNouns(bus_, channels::kTrajectory, kEveryUav, *trajectories_,
            [this](int uav, const Trajectory& trajectory, Utime) {
              if (uav != uav_) executive_.HearTeammate(uav, trajectory);
            });
  HearNouns(bus_, channels::kLidarScan, kEveryUav, *scans_,
            [this](int, LidarScan scan, Utime) { executive_.HearScan(std::move(scan)); });
  HearNouns(bus_, channels::kPath, kEveryUav, *paths_,
            [this](int, const Path& path, Utime) { executive_.HearPath(path); });
}

void TrajectorySmootherModule::SayTrajectory(Utime now) {
  const std::optional<Trajectory>& committed = executive_.committed();
  if (!committed) return;
  if (committed->id == said_trajectory_ && !trajectory_due_.Due(now)) return;
  said_trajectory_ = committed->id;
  bus_.Publish(channels::kTrajectory, uav_, Encode(*committed));
}

void TrajectorySmootherModule::SayStatus(Utime now) {
  FlightStatus status = executive_.Status(now);
  const bool changed = !said_status_ || Essence(status) != Essence(*said_status_);
  if (!changed && !status_due_.Due(now)) return;
  bus_.Publish(channels::kFlightStatus, uav_, Encode(status));
  said_status_ = std::move(status);
}

}  // namespace citrine

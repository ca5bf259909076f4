#include "modules/uav_dynamics/uav_dynamics_module.h"

#include <utility>

#include "modules/channels.h"
#include "modules/codec/fleet_status.h"
#include "modules/codec/map_summary.h"
#include "modules/codec/trajectory.h"
#include "modules/codec/uav_state.h"
#include "modules/hear_nouns.h"
#include "modules/mission_world.h"
#include "modules/runtime/cpu_stopwatch.h"

namespace citrine {

namespace {

constexpr std::uint64_t kLocalisationStream = 0x700;  // streams of the mission's seed, one a UAV

sim::FleetSimulator FleetOf(const ModuleContext& context) {
  const MissionConfig& config = context.config;
  const MissionSection& mission = config.mission;
  if (static_cast<int>(mission.spawns_m.size()) != mission.uavs) {
    throw ConfigError("mission.spawns_m has " + std::to_string(mission.spawns_m.size()) +
                      " places for mission.uavs = " + std::to_string(mission.uavs) + "; one a UAV is needed");
  }
  return {WorldOf(context)->mesh, mission.spawns_m, config.uav, config.dynamics,
          static_cast<std::uint64_t>(mission.seed)};
}

}  // namespace

UavDynamicsModule::UavDynamicsModule(const ModuleContext& context)
    : bus_(context.bus),
      health_(context.health),
      localisation_noise_m_(context.config.uav.localisation_noise_m),
      fleet_(FleetOf(context)),
      end_(context.config.mission.uavs, context.config.mission.time_limit_s),
      newest_trajectory_(static_cast<std::size_t>(fleet_.uavs())),
      trajectories_(bus_.HearAll(channels::kTrajectory)),
      fleet_statuses_(bus_.HearAll(channels::kFleetStatus)),
      map_summaries_(bus_.Hear(channels::kMapSummary)) {
  for (int i = 0; i < fleet_.uavs(); ++i) {
    localisation_.emplace_back(static_cast<std::uint64_t>(context.config.mission.seed),
                               kLocalisationStream + i);
  }
}

void UavDynamicsModule::Tick(const Step& step) {
  HearTrajectories();
  if (step.now > simulated_) {
    const CpuStopwatch stopwatch;
    fleet_.Step(simulated_, Seconds(step.now - simulated_));
    simulated_ = step.now;
    health_.Sample("dynamics_ms", stopwatch.ms());
  }
  SayStates();
  HearTheEnd(step.now);
}

void UavDynamicsModule::HearTrajectories() {
  HearNouns(bus_, channels::kTrajectory, fleet_.uavs(), *trajectories_,
            [this](int uav, Trajectory&& trajectory, Utime) {
              std::optional<Trajectory>& newest = newest_trajectory_[static_cast<std::size_t>(uav - 1)];
              if (newest && !Supersedes(trajectory, *newest)) return;
              newest = trajectory;
              fleet_.Follow(uav, std::move(trajectory));
            });
}

void UavDynamicsModule::HearTheEnd(Utime now) {
  HearNouns(bus_, channels::kMapSummary, *map_summaries_,
            [this](const MapSummary& summary, Utime) { end_.HearMap(summary.map_version, summary.digest); });
  HearNouns(bus_, channels::kFleetStatus, kEveryUav, *fleet_statuses_,
            [this](int uav, const FleetStatus& status, Utime) { end_.Hear(uav, status); });
  if (!stop_reason_) stop_reason_ = end_.At(now);
}

void UavDynamicsModule::SayStates() {
  for (int uav = 1; uav <= fleet_.uavs(); ++uav) {
    UavState said = fleet_.state(uav);
    if (localisation_noise_m_ > 0) {
      Random& random = localisation_[static_cast<std::size_t>(uav - 1)];
      for (int axis = 0; axis < 3; ++axis) said.X_WB.p(axis) += localisation_noise_m_ * random.Normal();
    }
    bus_.Publish(channels::kUavState, uav, Encode(said));
  }
}

}  // namespace citrine

#include "modules/lidar_emulator/lidar_emulator_module.h"

#include <cmath>
#include <utility>

#include "modules/channels.h"
#include "modules/codec/lidar_scan.h"
#include "modules/codec/uav_state.h"
#include "modules/hear_nouns.h"
#include "modules/mission_world.h"
#include "modules/runtime/cpu_stopwatch.h"

namespace citrine {
namespace {

constexpr std::uint64_t kNoiseStream = 0x11da0;  // streams of the mission's seed, one a UAV

/// The share of the period that a UAV waits before its first scan, in whole steps.
Utime PhaseOf(int uav, const MissionConfig& config) {
  const double share_s = (uav - 1) / (config.mission.uavs * config.lidar.rate_hz);
  return FromSeconds(config.dynamics.step_s) * std::llround(share_s / config.dynamics.step_s);
}

}  // namespace

LidarEmulatorModule::LidarEmulatorModule(const ModuleContext& context)
    : bus_(context.bus),
      health_(context.health),
      emulator_(std::make_shared<sim::RayScene>(*WorldOf(context)), context.config.lidar.model,
                context.config.lidar.noise_m_per_m2),
      states_(bus_.HearAll(channels::kUavState)) {
  const MissionConfig& config = context.config;
  for (int uav = 1; uav <= config.mission.uavs; ++uav)
    sensors_.push_back({Every(1 / config.lidar.rate_hz, PhaseOf(uav, config)),
                        Random(static_cast<std::uint64_t>(config.mission.seed),
                               kNoiseStream + static_cast<std::uint64_t>(uav)),
                        {},
                        {}});
}

void LidarEmulatorModule::Tick(const Step& step) {
  HearStates();
  for (std::size_t i = 0; i < sensors_.size(); ++i) {
    Sensor& sensor = sensors_[i];
    if (!sensor.newest || sensor.scanned == sensor.newest->utime || !sensor.every.Due(step.now)) continue;
    const CpuStopwatch stopwatch(CpuStopwatch::Of::kProcess);
    const LidarScan scan =
        emulator_.Scan(sensor.newest->utime, sensor.newest->X_WB, TeammatesOf(i), sensor.noise);
    sensor.scanned = scan.measured;
    health_.Sample("scan_ms", stopwatch.ms());
    bus_.Publish(channels::kLidarScan, static_cast<int>(i) + 1, Encode(scan));
  }
}

void LidarEmulatorModule::HearStates() {
  HearNouns(bus_, channels::kUavState, static_cast<int>(sensors_.size()), *states_,
            [this](int uav, const UavState& state, Utime) {
              std::optional<UavState>& newest = sensors_[static_cast<std::size_t>(uav) - 1].newest;
              if (!newest || state.utime > newest->utime) newest = state;
            });
}

/// Where the others were, by the newest that each has said: at the same instant, unless a message was lost.
std::vector<Eigen::Vector3d> LidarEmulatorModule::TeammatesOf(std::size_t self) const {
  std::vector<Eigen::Vector3d> teammates_W;
  for (std::size_t i = 0; i < sensors_.size(); ++i)
    if (i != self && sensors_[i].newest) teammates_W.push_back(sensors_[i].newest->X_WB.p);
  return teammates_W;
}

}  // namespace citrine

#include "modules/mission_report/flight_record_reader.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "modules/channels.h"
#include "modules/codec/bad_message.h"
#include "modules/codec/clock.h"
#include "modules/codec/fleet_assignment.h"
#include "modules/codec/fleet_status.h"
#include "modules/codec/flight_status.h"
#include "modules/codec/geometry.h"
#include "modules/codec/map_summary.h"
#include "modules/codec/mission_progress.h"
#include "modules/codec/module_health.h"
#include "modules/codec/trajectory.h"
#include "modules/codec/uav_state.h"
#include "modules/mission_report/recorded_message.h"

namespace citrine {
namespace {

/// Gathers a recording, message by message.
class RecordingBuilder {
 public:
  void Hear(const RecordedMessage& said) {
    recording_.flight.bytes_by_channel[said.event.channel] +=
        static_cast<std::int64_t>(said.event.bytes.size());
    try {
      if (said.uav > 0)
        HearUav(said);
      else
        HearFleet(said);
    } catch (const BadMessage&) {
      ++recording_.messages_bad;
    }
  }

  Recording Take() {
    for (const auto& [module, health] : health_) recording_.flight.messages_lost += health.lost;
    return std::move(recording_);
  }

 private:
  void HearUav(const RecordedMessage& said) {
    auto& uavs = recording_.flight.uavs;
    if (static_cast<int>(uavs.size()) < said.uav) uavs.resize(static_cast<std::size_t>(said.uav));
    logs::UavFlight& uav = uavs[static_cast<std::size_t>(said.uav - 1)];
    said.On(channels::kUavState, [&](const auto& m) { uav.states.push_back(Decode(m)); });
    said.On(channels::kLidarScan, [&](const auto& m) {
      uav.scans.push_back({m.measured_utime, DecodePose(m.p_WS, m.q_WS, "lidar_scan_t: pose")});
    });
    said.On(channels::kFleetStatus, [&](const auto& m) { uav.statuses.push_back({m.utime, Decode(m)}); });
    said.On(channels::kFlightStatus, [&](const auto& m) {
      uav.flight_statuses.push_back({m.utime, Decode(m)});
    });
    said.On(channels::kTrajectory, [&](const auto& m) {
      Trajectory trajectory = Decode(m);
      if (uav.trajectories.empty() || Supersedes(trajectory, uav.trajectories.back()))
        uav.trajectories.push_back(std::move(trajectory));
    });
  }

  void HearFleet(const RecordedMessage& said) {
    logs::FlightRecord& flight = recording_.flight;
    said.On(channels::kClock, [&](const auto& m) {
      const Clock clock = Decode(m);
      flight.end = clock.utime;
      if (clock.state == Clock::State::kDone) recording_.stop_reason = clock.reason;
    });
    said.On(channels::kMapSummary, [&](const auto& m) { flight.map_summary = Decode(m); });
    said.On(channels::kMissionProgress, [&](const auto& m) {
      flight.progress.push_back({m.utime, Decode(m)});
    });
    said.On(channels::kFleetAssignment, [&](const auto& m) {
      if (plans_.insert(m.plan_id).second) flight.assignments.push_back(Decode(m));
    });
    said.On(channels::kMissionConfig, [&](const auto& m) { recording_.config = Decode(m); });
    said.On(channels::kModuleHealth, [&](const auto& m) { HearHealth(Decode(m)); });
  }

  void HearHealth(const ModuleHealth& health) {
    for (const auto& [name, values] : health.samples) {
      auto& samples = recording_.flight.samples[name];
      samples.insert(samples.end(), values.begin(), values.end());
    }
    const std::string module = health.name + "/" + std::to_string(health.uav);
    health_[module] = health;
    auto& peak_kb = recording_.peak_memory_kb_by_module[module];
    peak_kb = std::max(peak_kb, health.peak_memory_kb);
  }

  Recording recording_;
  std::set<std::int64_t> plans_;
  std::map<std::string, ModuleHealth> health_;  ///< the newest of each module
};

}  // namespace

Recording ReadRecording(const std::vector<LogEvent>& events) {
  RecordingBuilder builder;
  for (const LogEvent& event : events) builder.Hear(RecordedMessage(event));
  return builder.Take();
}

}  // namespace citrine

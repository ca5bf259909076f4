#include "modules/mission_report/mission_metrics.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>

#include "core/digest.h"
#include "logs/flight_measures.h"
#include "logs/percentile.h"

namespace citrine {
namespace {

void Identify(const Recording& recording, const ReportInputs& inputs, logs::Metrics& m) {
  const MissionSection& mission = inputs.config.mission;
  m.mission = mission.name;
  m.world = std::filesystem::path(mission.world).filename();
  m.strategy = inputs.config.planner.strategy;
  m.uavs = mission.uavs;
  m.seed = mission.seed;
  m.in_process = inputs.in_process;
  m.pace = inputs.pace;
  m.stop_reason = !inputs.stop_reason.empty()      ? inputs.stop_reason
                  : !recording.stop_reason.empty() ? recording.stop_reason
                                                   : "interrupted";
  m.completed = m.stop_reason == "surface_complete";
  m.mission_time_s = Seconds(recording.flight.end);
  m.wall_time_s = inputs.wall_time_s;
  if (m.wall_time_s && *m.wall_time_s > 0) m.real_time_factor = m.mission_time_s / *m.wall_time_s;
  if (!inputs.commit.empty())
    m.commit = inputs.commit;
  else if (recording.config && !recording.config->commit.empty())
    m.commit = recording.config->commit + (recording.config->dirty ? "-dirty" : "");
}

void MeasureFlight(const logs::FlightRecord& flight, logs::Metrics& m) {
  for (const logs::UavFlight& uav : flight.uavs) m.path_m.push_back(logs::PathLength(uav.states));
  if (m.path_m.empty()) return;
  m.makespan_m = *std::max_element(m.path_m.begin(), m.path_m.end());
  m.average_path_m =
      std::accumulate(m.path_m.begin(), m.path_m.end(), 0.0) / static_cast<double>(m.path_m.size());
  m.mean_speed_mps = logs::MeanSpeedUnderWay(flight.uavs);
  m.collisions = logs::Collisions(flight.uavs);
  m.min_uav_separation_m = logs::MinOf(logs::SeparationOverTime(flight.uavs));
  for (const logs::UavFlight& uav : flight.uavs) {
    const auto speed = logs::MaxOf(logs::SpeedOverTime(uav.states));
    const auto acceleration = logs::MaxOf(logs::AccelerationOverTime(uav.states));
    if (speed) m.max_speed_mps = std::max(m.max_speed_mps.value_or(0), *speed);
    if (acceleration) m.max_acceleration_mps2 = std::max(m.max_acceleration_mps2.value_or(0), *acceleration);
  }
}

void MeasureMap(const logs::FlightRecord& flight, logs::Metrics& m) {
  if (flight.map_summary) m.map_digest = Hex(flight.map_summary->digest);
  if (flight.progress.empty()) return;
  const MissionProgress& last = flight.progress.back().value;
  m.z_sat = last.z_sat;
  m.z_bar_sat = last.z_bar_sat;
  m.z_goal = last.z_goal;
  if (last.surface_voxels > 0) m.voxels_reaching_goal_pct = 100.0 * last.voxels_at_goal / last.surface_voxels;
}

std::optional<double> SumOf(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? std::optional(*a + *b) : std::nullopt;
}

void MeasureDeciding(const logs::FlightRecord& flight, logs::Metrics& m) {
  const auto percentile = [&](const char* name, double percent) -> std::optional<double> {
    const auto found = flight.samples.find(name);
    if (found == flight.samples.end()) return std::nullopt;
    return logs::Percentile(found->second, percent);
  };
  m.decisions = logs::Decisions(flight.uavs);
  m.elements_given_up = logs::ElementsGivenUp(flight.uavs);
  m.elements_unreachable = logs::ElementsUnreachable(flight.uavs);
  m.replan_ms_p50 = percentile("replan_ms", 50);
  m.replan_ms_p95 = percentile("replan_ms", 95);
  m.views_p50 = percentile("views", 50);
  m.elements_p50 = percentile("elements", 50);
  m.plan_ms_p95 = SumOf(percentile("path_ms", 95), percentile("smooth_plan_ms", 95));
  m.smoothing_ms_p95 = percentile("smoothing_ms", 95);
  m.integration_ms_p50 = percentile("integration_ms", 50);
  m.integration_ms_p95 = percentile("integration_ms", 95);
  m.imbalance_corrections = static_cast<std::int64_t>(flight.assignments.size());
  if (*m.decisions > 0)
    m.corrections_per_decision =
        static_cast<double>(*m.imbalance_corrections) / static_cast<double>(*m.decisions);
}

void MeasureSystem(const Recording& recording, bool in_process, logs::Metrics& m) {
  m.bus_bytes_by_channel = recording.flight.bytes_by_channel;
  m.bus_bytes = 0;
  for (const auto& [channel, bytes] : m.bus_bytes_by_channel) *m.bus_bytes += bytes;
  m.messages_lost = recording.flight.messages_lost;
  double sum_kb = 0, largest_kb = 0;
  for (const auto& [module, kb] : recording.peak_memory_kb_by_module) {
    sum_kb += static_cast<double>(kb);
    largest_kb = std::max(largest_kb, static_cast<double>(kb));
  }
  if (sum_kb > 0) m.peak_memory_mb = (in_process ? largest_kb : sum_kb) / 1024;
}

}  // namespace

logs::Metrics MetricsOf(const Recording& recording, const ReportInputs& inputs) {
  logs::Metrics metrics;
  Identify(recording, inputs, metrics);
  MeasureFlight(recording.flight, metrics);
  MeasureMap(recording.flight, metrics);
  MeasureDeciding(recording.flight, metrics);
  MeasureSystem(recording, inputs.in_process, metrics);
  metrics.threshold_m = std::sqrt(1.5) * inputs.config.map.voxel_m;
  return metrics;
}

}  // namespace citrine

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace citrine::logs {

/// metrics.json: SI units and percent, keys in this order; what does not apply is null.
struct Metrics {
  std::string mission, world;
  std::optional<std::string> world_hash;
  std::string strategy;
  int uavs = 0, seed = 0;
  bool in_process = false;
  double pace = 1;  ///< mission seconds a second of the wall; 0: as fast as it goes, "max" in the file
  bool completed = false;
  std::string stop_reason;
  double mission_time_s = 0;
  std::optional<double> wall_time_s, real_time_factor;
  std::optional<double> makespan_m, average_path_m;
  std::vector<double> path_m;  ///< index: UAV id - 1
  std::optional<double> mean_speed_mps;
  std::optional<double> coverage_pct, precision_pct, f_score_pct, threshold_m;
  std::optional<double> observable_coverage_pct, goal_coverage_pct, object_goal_coverage_pct;
  std::optional<double> surface_error_mean_m, surface_error_p95_m;
  std::optional<double> z_sat, z_bar_sat, z_goal, voxels_reaching_goal_pct;
  std::optional<std::int64_t> collisions;
  std::optional<double> min_obstacle_clearance_m, min_uav_separation_m, max_speed_mps, max_acceleration_mps2;
  std::optional<std::int64_t> decisions;
  std::optional<double> replan_ms_p50, replan_ms_p95, views_p50, elements_p50;
  std::optional<std::int64_t> elements_given_up, elements_unreachable;
  std::optional<double> plan_ms_p95, smoothing_ms_p95, integration_ms_p50, integration_ms_p95;
  std::optional<std::int64_t> imbalance_corrections;
  std::optional<double> corrections_per_decision;
  std::optional<std::int64_t> bus_bytes;
  std::map<std::string, std::int64_t> bus_bytes_by_channel;
  std::optional<std::int64_t> messages_lost;
  std::optional<std::string> map_digest, log_digest;
  std::optional<double> peak_memory_mb;
  std::optional<std::string> commit;

  /// Names every key once, in the file's order.
  template <class V>
  void Visit(V& v) {
    v("mission", mission);
    v("world", world);
    v("world_hash", world_hash);
    v("strategy", strategy);
    v("uavs", uavs);
    v("seed", seed);
    v("in_process", in_process);
    v("pace", pace);
    v("completed", completed);
    v("stop_reason", stop_reason);
    v("mission_time_s", mission_time_s);
    v("wall_time_s", wall_time_s);
    v("real_time_factor", real_time_factor);
    v("makespan_m", makespan_m);
    v("average_path_m", average_path_m);
    v("path_m", path_m);
    v("mean_speed_mps", mean_speed_mps);
    v("coverage_pct", coverage_pct);
    v("precision_pct", precision_pct);
    v("f_score_pct", f_score_pct);
    v("threshold_m", threshold_m);
    v("observable_coverage_pct", observable_coverage_pct);
    v("goal_coverage_pct", goal_coverage_pct);
    v("object_goal_coverage_pct", object_goal_coverage_pct);
    v("surface_error_mean_m", surface_error_mean_m);
    v("surface_error_p95_m", surface_error_p95_m);
    v("z_sat", z_sat);
    v("z_bar_sat", z_bar_sat);
    v("z_goal", z_goal);
    v("voxels_reaching_goal_pct", voxels_reaching_goal_pct);
    v("collisions", collisions);
    v("min_obstacle_clearance_m", min_obstacle_clearance_m);
    v("min_uav_separation_m", min_uav_separation_m);
    v("max_speed_mps", max_speed_mps);
    v("max_acceleration_mps2", max_acceleration_mps2);
    v("decisions", decisions);
    v("replan_ms_p50", replan_ms_p50);
    v("replan_ms_p95", replan_ms_p95);
    v("views_p50", views_p50);
    v("elements_p50", elements_p50);
    v("elements_given_up", elements_given_up);
    v("elements_unreachable", elements_unreachable);
    v("plan_ms_p95", plan_ms_p95);
    v("smoothing_ms_p95", smoothing_ms_p95);
    v("integration_ms_p50", integration_ms_p50);
    v("integration_ms_p95", integration_ms_p95);
    v("imbalance_corrections", imbalance_corrections);
    v("corrections_per_decision", corrections_per_decision);
    v("bus_bytes", bus_bytes);
    v("bus_bytes_by_channel", bus_bytes_by_channel);
    v("messages_lost", messages_lost);
    v("map_digest", map_digest);
    v("log_digest", log_digest);
    v("peak_memory_mb", peak_memory_mb);
    v("commit", commit);
  }
};

/// The text of metrics.json; numbers to six decimals.
std::string ToJson(const Metrics& metrics);

/// Reads it back; a key that is missing or null stays as it is in a fresh Metrics.
/// @throws std::runtime_error naming what is not JSON, or the key whose value is of another kind
Metrics MetricsFromJson(const std::string& text);

}  // namespace citrine::logs

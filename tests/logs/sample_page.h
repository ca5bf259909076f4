#pragma once

#include <cmath>

#include "logs/report_page.h"

namespace citrine::logs {

/// What two UAVs that fly in circles for two minutes might leave.
inline ReportPage SamplePage() {
  ReportPage page;
  page.metrics.mission = "house";
  page.metrics.world = "worlds/house.sdf";
  page.metrics.strategy = "quality_adaptive";
  page.metrics.uavs = 2;
  page.metrics.completed = true;
  page.metrics.stop_reason = "surface_complete";
  page.metrics.mission_time_s = 120;
  page.metrics.coverage_pct = 79.9;
  page.metrics.precision_pct = 88;
  page.metrics.f_score_pct = 83.75;
  page.metrics.collisions = 0;
  page.volume_W = Eigen::AlignedBox3d(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(45, 40, 20));
  page.config_toml = "[mission]\nname = \"a <b> & 'c'\"\n";
  page.command = "./citrine run house --set planner.gamma=2";
  page.topdown_png = {1, 2, 3, 4};
  page.record.uavs.resize(2);
  for (int i = 0; i < 2; ++i)
    for (int k = 0; k < 6000; ++k) {
      UavState state;
      state.utime = k * 20'000;
      state.X_WB.p = {5 + 20 * i + 4 * std::cos(k * 0.01), 20 + 10 * std::sin(k * 0.01), 3};
      state.v_W = {-2 * std::sin(k * 0.01), 5 * std::cos(k * 0.01), 0};
      page.record.uavs[i].states.push_back(state);
    }
  for (int k = 0; k < 240; ++k) {
    MissionProgress progress;
    progress.surface_voxels = 100 * k;
    progress.voxels_at_goal = 80 * k;
    page.record.progress.push_back({k * 500'000, progress});
  }
  for (int k = 0; k < 5; ++k) {
    FleetAssignment assignment;
    assignment.plan_id = k * 20'000'000 * 16 + 1;
    page.record.assignments.push_back(assignment);
    FleetStatus status;
    status.decisions = k;
    page.record.uavs[0].statuses.push_back({k * 10'000'000, status});
  }
  page.goal_coverage_pct = {{1, 10}, {2, 50}};
  page.object_goal_coverage_pct = {{1, 5}, {2, 40}};
  page.record.end = 120'000'000;
  page.record.bytes_by_channel = {
      {"UAV1_STATE", 500'000}, {"UAV2_STATE", 500'000}, {"MAP_BLOCKS", 9'000'000}};
  page.record.samples = {{"replan_ms", {1, 2, 30}}, {"views", {5}}};
  return page;
}

}  // namespace citrine::logs

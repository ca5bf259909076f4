#include "modules/launch/results_table.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <optional>

namespace citrine {
namespace {

std::string Number(const std::optional<double>& value, const char* unit, int decimals = 1) {
  if (!value) return "-";
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%.*f%s", decimals, *value, unit);
  return text.data();
}

std::string Row(const std::string& name, const std::string& value) {
  return "  " + name + std::string(name.size() < 22 ? 22 - name.size() : 1, ' ') + value + "\n";
}

}  // namespace

std::string ResultsTable(const logs::Metrics& metrics, const std::string& out) {
  std::string text = metrics.mission + ", " + metrics.strategy + ", " + std::to_string(metrics.uavs) +
                     " UAVs, seed " + std::to_string(metrics.seed) + ": " + metrics.stop_reason + "\n";
  text += Row("mission time",
              Number(metrics.mission_time_s, " s") + ", wall " + Number(metrics.wall_time_s, " s"));
  text += Row("path", "longest " + Number(metrics.makespan_m, " m") + ", mean " +
                          Number(metrics.average_path_m, " m"));
  text +=
      Row("surface", "coverage " + Number(metrics.coverage_pct, " %") + ", precision " +
                         Number(metrics.precision_pct, " %") + ", F " + Number(metrics.f_score_pct, " %") +
                         " at " + Number(metrics.threshold_m, " m", 3));
  text += Row("observable, at goal", Number(metrics.observable_coverage_pct, " %") + ", " +
                                         Number(metrics.goal_coverage_pct, " %") + ", without ground " +
                                         Number(metrics.object_goal_coverage_pct, " %"));
  text += Row("voxels at goal", Number(metrics.voxels_reaching_goal_pct, " %"));
  text += Row("collisions", (metrics.collisions ? std::to_string(*metrics.collisions) : "-") +
                                ", nearest obstacle " + Number(metrics.min_obstacle_clearance_m, " m", 2) +
                                ", nearest UAV " + Number(metrics.min_uav_separation_m, " m", 2));
  text += Row("messages lost", !metrics.messages_lost ? "-"
                               : *metrics.messages_lost > 0
                                   ? std::to_string(*metrics.messages_lost) +
                                         ": a slow host or a small buffer, see ./citrine doctor"
                                   : "0");
  text += Row("log digest", metrics.log_digest.value_or("-"));
  for (const char* file :
       {"report.html", "metrics.json", "mesh.ply", "topdown.png", "topdown.mp4", "mission.lcmlog"})
    if (const auto path = std::filesystem::path(out) / file; std::filesystem::exists(path))
      text += "  " + path.string() + "\n";
  return text;
}

}  // namespace citrine

#include "logs/report_tables.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "logs/html_text.h"
#include "logs/number_text.h"
#include "logs/paper_results.h"

namespace citrine::logs {
namespace {

using Rows = std::vector<std::pair<std::string, std::string>>;

std::string Table(const std::string& title, const Rows& rows) {
  std::string html = "<table class=\"numbers\"><caption>" + Escape(title) + "</caption>";
  for (const auto& [name, value] : rows)
    html += "<tr><th>" + Escape(name) + "</th><td>" + Escape(value) + "</td></tr>";
  return html + "</table>\n";
}

std::string With(const std::optional<double>& value, int decimals, const std::string& unit) {
  return value ? Fixed(*value, decimals) + " " + unit : Fixed(value, decimals);
}
std::string Count(const std::optional<std::int64_t>& value) { return value ? std::to_string(*value) : "–"; }
std::string Pair(const std::optional<double>& p50, const std::optional<double>& p95) {
  return Fixed(p50, 2) + " / " + Fixed(p95, 2) + " ms";
}

std::string Lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string Row(const std::string& method, const std::array<std::optional<double>, 5>& values,
                const char* style) {
  std::string html = std::string("<tr class=\"") + style + "\"><th>" + Escape(method) + "</th>";
  for (std::size_t k = 0; k < values.size(); ++k) html += "<td>" + Fixed(values[k], k < 2 ? 1 : 2) + "</td>";
  return html + "</tr>";
}

Rows Reconstruction(const ReportPage& page) {
  const Metrics& m = page.metrics;
  Rows rows = {{"coverage, whole true surface", With(m.coverage_pct, 2, "%")},
               {"coverage, observable surface", With(m.observable_coverage_pct, 2, "%")},
               {"seen from within d*", With(m.goal_coverage_pct, 2, "%")},
               {"the same, without the ground", With(m.object_goal_coverage_pct, 2, "%")},
               {"precision", With(m.precision_pct, 2, "%")},
               {"F-score", With(m.f_score_pct, 2, "%")},
               {"threshold sqrt(3/2) d_s", With(m.threshold_m, 4, "m")},
               {"surface error, mean", With(m.surface_error_mean_m, 4, "m")},
               {"surface error, 95 %", With(m.surface_error_p95_m, 4, "m")},
               {"voxels at their goal", With(m.voxels_reaching_goal_pct, 2, "%")},
               {"mean quality / goal", Fixed(m.z_bar_sat, 5) + " / " + Fixed(m.z_goal, 5) + " 1/m²"}};
  if (page.score) {
    const ReconstructionScore& s = *page.score;
    rows.emplace_back("samples, true / reconstructed",
                      std::to_string(s.true_samples) + " / " + std::to_string(s.mesh_samples));
    rows.emplace_back("cropping", "the truth to the mission volume");
    rows.emplace_back("points of the reconstruction", Fixed(s.options.neighbours_per_m2, 0) + " and " +
                                                          Fixed(s.options.samples_per_m2, 0) + " /m², seed " +
                                                          std::to_string(s.options.seed));
  }
  return rows;
}

Rows Flight(const Metrics& m) {
  return {{"mission time", MinutesSeconds(m.mission_time_s)},
          {"makespan (longest path)", With(m.makespan_m, 1, "m")},
          {"average path", With(m.average_path_m, 1, "m")},
          {"mean speed under way", With(m.mean_speed_mps, 2, "m/s")},
          {"largest speed", With(m.max_speed_mps, 2, "m/s")},
          {"largest acceleration", With(m.max_acceleration_mps2, 2, "m/s²")},
          {"collisions", Count(m.collisions)},
          {"least obstacle clearance", With(m.min_obstacle_clearance_m, 2, "m")},
          {"least separation", With(m.min_uav_separation_m, 2, "m")}};
}

Rows Deciding(const Metrics& m) {
  return {{"decisions", Count(m.decisions)},
          {"imbalance corrections", Count(m.imbalance_corrections)},
          {"corrections a decision", Fixed(m.corrections_per_decision, 3)},
          {"a decision takes, p50 / p95", Pair(m.replan_ms_p50, m.replan_ms_p95)},
          {"views considered, p50", Fixed(m.views_p50, 0)},
          {"active elements, p50", Fixed(m.elements_p50, 0)},
          {"elements given up", Count(m.elements_given_up)},
          {"elements unreachable", Count(m.elements_unreachable)},
          {"path search and smoothing with checks, sum of the p95 of both", With(m.plan_ms_p95, 2, "ms")},
          {"smoothing, p95", With(m.smoothing_ms_p95, 2, "ms")}};
}

Rows System(const Metrics& m) {
  return {{"wall time", With(m.wall_time_s, 1, "s")},
          {"times real time", Fixed(m.real_time_factor, 2)},
          {"one process", m.in_process ? "yes" : "no"},
          {"scan integration, p50 / p95", Pair(m.integration_ms_p50, m.integration_ms_p95)},
          {"said on the bus", m.bus_bytes ? Bytes(static_cast<double>(*m.bus_bytes)) : "–"},
          {"messages lost", Count(m.messages_lost)},
          {"peak memory", With(m.peak_memory_mb, 0, "MB")},
          {"map digest", m.map_digest.value_or("–")},
          {"log digest", m.log_digest.value_or("–")},
          {"world hash", m.world_hash.value_or("–")},
          {"commit", m.commit.value_or("–")}};
}

}  // namespace

std::string VerdictLine(const ReportPage& page) {
  const Metrics& m = page.metrics;
  const bool collided = m.collisions.value_or(0) > 0;
  std::string text = m.completed ? "Surface complete" : "Not completed (" + m.stop_reason + ")";
  text += " after " + MinutesSeconds(m.mission_time_s) + ", ";
  text += collided ? std::to_string(*m.collisions) + " collision" + (*m.collisions > 1 ? "s" : "")
                   : "no collision";
  if (m.makespan_m) text += ": makespan " + Fixed(m.makespan_m, 1) + " m";
  if (m.f_score_pct)
    text += ", coverage " + Fixed(m.coverage_pct, 1) + " %, precision " + Fixed(m.precision_pct, 1) +
            " %, F-score " + Fixed(m.f_score_pct, 1) + " %";
  return std::string("<p class=\"verdict ") + (m.completed && !collided ? "good" : "bad") + "\">" +
         Escape(text) + ".</p>\n";
}

std::string PaperTable(const ReportPage& page) {
  const Metrics& m = page.metrics;
  std::string html =
      "<table class=\"paper\"><caption>Beside table II of the paper</caption><tr><th></th><th>makespan "
      "[m]</th>"
      "<th>average path [m]</th><th>coverage [%]</th><th>precision [%]</th><th>F-score</th></tr>";
  std::string name = "this run: " + m.strategy;
  if (!page.balance) name += ", no imbalance correction";
  name += ", " + std::to_string(m.uavs) + " UAVs, d* " + Fixed(page.d_star_m, 1) + " m, seed " +
          std::to_string(m.seed);
  html += Row(name, {m.makespan_m, m.average_path_m, m.coverage_pct, m.precision_pct, m.f_score_pct}, "ours");
  for (const PaperResult& p : kPaperResults)
    if (Lower(m.mission + " " + m.world).find(p.world) != std::string::npos)
      html += Row(std::string(p.method),
                  {p.makespan_m, p.average_path_m, p.coverage_pct, p.precision_pct, p.f_score_pct}, "theirs");
  return html + "</table>\n";
}

std::string NumberTables(const ReportPage& page) {
  return Table("Reconstruction", Reconstruction(page)) + Table("Flight", Flight(page.metrics)) +
         Table("Deciding", Deciding(page.metrics)) + Table("System", System(page.metrics));
}

}  // namespace citrine::logs

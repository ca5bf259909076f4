#include "logs/decision_plots.h"

#include "logs/svg_chart.h"

namespace citrine::logs {
namespace {

constexpr const char* kTime = "mission time [s]";
constexpr std::int64_t kPlanIdsPerMicrosecond = 16;  // FleetAssignment::plan_id

/// A staircase: level until a value changes.
void Step(Series& series, double time_s, double value) {
  if (!series.empty()) {
    if (series.back().second == value) return;
    series.emplace_back(time_s, series.back().second);
  }
  series.emplace_back(time_s, value);
}

std::vector<Curve> GoalsChosen(const FlightRecord& record) {
  std::vector<Curve> curves;
  for (const UavFlight& uav : record.uavs) {
    const int i = static_cast<int>(curves.size());
    Curve curve{"UAV " + std::to_string(i + 1), {{0, 0}}, i};
    for (const auto& [utime, status] : uav.statuses)
      Step(curve.points, Seconds(utime), static_cast<double>(status.decisions));
    curve.points.emplace_back(Seconds(record.end), curve.points.back().second);
    curves.push_back(curve);
  }
  return curves;
}

Curve Corrections(const FlightRecord& record) {
  Curve curve{"corrections", {{0, 0}}, 0};
  int count = 0;
  for (const FleetAssignment& assignment : record.assignments)
    Step(curve.points, Seconds(assignment.plan_id / kPlanIdsPerMicrosecond), ++count);
  curve.points.emplace_back(Seconds(record.end), count);
  return curve;
}

}  // namespace

std::string CoveragePlot(const ReportPage& page) {
  if (page.goal_coverage_pct.empty()) return "";
  return LineChart(
      {"True surface seen from within d*", kTime, "% of what can be so seen"},
      {{"all", page.goal_coverage_pct, 0}, {"without the ground", page.object_goal_coverage_pct, 1}});
}

std::string DecisionPlots(const ReportPage& page) {
  std::string html = LineChart({"Goals chosen", kTime, "goals"}, GoalsChosen(page.record));
  if (page.record.uavs.size() > 1)
    html += LineChart({"Imbalance corrections", kTime, "corrections"}, {Corrections(page.record)});
  return html;
}

}  // namespace citrine::logs

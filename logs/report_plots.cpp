#include "logs/report_plots.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "logs/flight_measures.h"
#include "logs/number_text.h"
#include "logs/percentile.h"
#include "logs/svg_chart.h"

namespace citrine::logs {
namespace {

constexpr const char* kTime = "mission time [s]";

Series Of(const FlightRecord& record, const std::function<double(const MissionProgress&)>& value) {
  Series series;
  for (const auto& [utime, progress] : record.progress) series.emplace_back(Seconds(utime), value(progress));
  return series;
}

std::vector<Curve> Named(const std::vector<Series>& by_uav) {
  std::vector<Curve> curves;
  for (const Series& series : by_uav) {
    const int i = static_cast<int>(curves.size());
    curves.push_back({"UAV " + std::to_string(i + 1), series, i});
  }
  return curves;
}

std::vector<Curve> PerUav(const std::vector<UavFlight>& uavs,
                          Series (*measure)(const std::vector<UavState>&)) {
  std::vector<Series> by_uav;
  for (const UavFlight& uav : uavs) by_uav.push_back(measure(uav.states));
  return Named(by_uav);
}

std::string Paths(const ReportPage& page) {
  std::vector<std::vector<Eigen::Vector2d>> paths_W;
  for (const UavFlight& uav : page.record.uavs) {
    auto& path = paths_W.emplace_back();
    for (const UavState& state : uav.states) path.push_back(state.X_WB.p.head<2>());
  }
  const Eigen::AlignedBox2d box(page.volume_W.min().head<2>(), page.volume_W.max().head<2>());
  return PathsFromAbove("Paths from above", paths_W, box);
}

std::string Workload(const std::vector<UavFlight>& uavs) {
  std::vector<Bar> bars;
  for (std::size_t i = 0; i < uavs.size(); ++i) {
    const double path_m = PathLength(uavs[i].states);
    const auto decisions = uavs[i].statuses.empty() ? 0 : uavs[i].statuses.back().value.decisions;
    bars.push_back({"UAV " + std::to_string(i + 1), path_m,
                    Fixed(path_m, 1) + " m, " + std::to_string(decisions) + " goals", static_cast<int>(i)});
  }
  return BarChart("Workload: metres flown and goals chosen", bars);
}

/// UAV<i>_STATE of all UAVs is one row.
std::string KindOf(const std::string& channel) {
  const std::size_t noun = channel.find('_');
  if (channel.rfind("UAV", 0) != 0 || noun == std::string::npos) return channel;
  return "UAV*" + channel.substr(noun);
}

std::string BusBytes(const FlightRecord& record) {
  std::map<std::string, double> bytes_by_kind;
  for (const auto& [channel, bytes] : record.bytes_by_channel)
    bytes_by_kind[KindOf(channel)] += static_cast<double>(bytes);
  std::vector<Bar> bars;
  const double duration_s = std::max(Seconds(record.end), 1e-6);
  for (const auto& [kind, bytes] : bytes_by_kind)
    bars.push_back({kind, bytes, Bytes(bytes) + ", " + Bytes(bytes / duration_s) + "/s"});
  std::stable_sort(bars.begin(), bars.end(), [](const Bar& a, const Bar& b) { return a.value > b.value; });
  return BarChart("Said on the bus, by channel", bars);
}

std::string ComputingTimes(const FlightRecord& record) {
  std::vector<Bar> bars, sums;
  for (const auto& [name, samples] : record.samples) {
    if (name.size() < 3 || name.substr(name.size() - 3) != "_ms") continue;
    const std::string what = name.substr(0, name.size() - 3);
    const double sum_s = std::accumulate(samples.begin(), samples.end(), 0.0) / 1e3;
    sums.push_back({what, sum_s, Fixed(sum_s, 1) + " s in " + std::to_string(samples.size())});
    for (const double percent : {50.0, 95.0}) {
      const double ms = Percentile(samples, percent).value_or(0);
      bars.push_back(
          {what + (percent < 60 ? " p50" : " p95"), ms, Fixed(ms, 2) + " ms", percent < 60 ? 0 : 1});
    }
  }
  if (bars.empty()) return "";
  return BarChart("Computing time, measured on this host", bars) + BarChart("The same in all", sums);
}

}  // namespace

std::string ProgressPlots(const FlightRecord& record) {
  if (record.progress.empty()) return "";
  using P = const MissionProgress&;
  std::string html;
  html += LineChart({"Surface voxels", kTime, "voxels"},
                    {{"surface", Of(record, [](P p) { return p.surface_voxels; }), 0},
                     {"at their goal w*", Of(record, [](P p) { return p.voxels_at_goal; }), 2}});
  html += LineChart(
      {"Share of the surface at its goal", kTime, "%"},
      {{"share",
        Of(record,
           [](P p) { return p.surface_voxels > 0 ? 100.0 * p.voxels_at_goal / p.surface_voxels : 0.0; }),
        2}});
  html += LineChart({"Active elements", kTime, "elements"},
                    {{"incomplete surface (ISE)", Of(record, [](P p) { return p.elements_ise; }), 3},
                     {"low quality (LQSE)", Of(record, [](P p) { return p.elements_lqse; }), 1}});
  html += LineChart({"Quality of the map", kTime, "1/m²"},
                    {{"mean of min(w, w*)", Of(record, [](P p) { return p.z_bar_sat; }), 0},
                     {"goal Z*", Of(record, [](P p) { return p.z_goal; }), 1, true}});
  html += LineChart({"Z_sat: quality times extent", kTime, "Z_sat"},
                    {{"Z_sat", Of(record, [](P p) { return p.z_sat; }), 0}});
  return html;
}

std::string FlightPlots(const ReportPage& page) {
  const auto& uavs = page.record.uavs;
  std::string html = Paths(page);
  html += Workload(uavs);
  html += LineChart({"Metres flown", kTime, "m"}, PerUav(uavs, PathLengthOverTime));
  html += LineChart({"Speed", kTime, "m/s"}, PerUav(uavs, SpeedOverTime),
                    std::make_pair(std::string("v_max"), page.limits.speed_max_mps));
  html += LineChart({"Acceleration, mean over 0.1 s", kTime, "m/s²"}, PerUav(uavs, AccelerationOverTime),
                    std::make_pair(std::string("a_max"), page.limits.acceleration_max_mps2));
  if (!page.clearance_by_uav.empty())
    html += LineChart({"Clearance to the true world", kTime, "m"}, Named(page.clearance_by_uav),
                      std::make_pair(std::string("radius"), page.limits.radius_m));
  if (uavs.size() > 1)
    html += LineChart({"Separation from the nearest UAV", kTime, "m"}, Named(SeparationOverTime(uavs)),
                      std::make_pair(std::string("two radii"), 2 * page.limits.radius_m));
  return html;
}

std::string SystemPlots(const FlightRecord& record) { return BusBytes(record) + ComputingTimes(record); }

}  // namespace citrine::logs

#include "logs/progress_csv.h"

#include <algorithm>

#include "logs/flight_measures.h"
#include "logs/number_text.h"

namespace citrine::logs {
namespace {

/// The newest value at a time; 0 before the first.
double At(const Series& series, double time_s) {
  const auto later = std::upper_bound(series.begin(), series.end(), time_s,
                                      [](double t, const auto& sample) { return t < sample.first; });
  return later == series.begin() ? 0.0 : std::prev(later)->second;
}

}  // namespace

std::string ProgressCsv(const FlightRecord& record) {
  std::string text =
      "time_s,surface_voxels,voxels_at_goal,elements_ise,elements_lqse,z_bar_sat,z_sat,z_goal,known_pct";
  std::vector<Series> paths;
  for (const UavFlight& uav : record.uavs) {
    paths.push_back(PathLengthOverTime(uav.states));
    text += ",path" + std::to_string(paths.size()) + "_m";
  }
  text += "\n";
  for (const auto& [utime, p] : record.progress) {
    text += Fixed(Seconds(utime), 3);
    for (const int count : {p.surface_voxels, p.voxels_at_goal, p.elements_ise, p.elements_lqse})
      text += "," + std::to_string(count);
    for (const double z : {p.z_bar_sat, p.z_sat, p.z_goal}) text += "," + Fixed(z, 6);
    text += "," + Fixed(p.known_pct, 3);
    for (const Series& path : paths) text += "," + Fixed(At(path, Seconds(utime)), 3);
    text += "\n";
  }
  return text;
}

}  // namespace citrine::logs

#include "logs/progress_csv.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <stdexcept>

#include "logs/number_text.h"

namespace citrine::logs {
namespace {

std::vector<std::string> CellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

double NumberIn(const std::vector<std::string>& cells, std::size_t index) {
  double value = 0;
  if (index < cells.size()) {
    const std::string& cell = cells[index];
    if (std::from_chars(cell.data(), cell.data() + cell.size(), value).ec == std::errc()) return value;
  }
  throw std::runtime_error("progress.csv: a line is cut short or holds no number");
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
    for (const Series& path : paths) text += "," + Fixed(ValueAt(path, Seconds(utime)), 3);
    text += "\n";
  }
  return text;
}

Series ColumnOverTime(const std::string& progress_csv, const std::string& column) {
  std::istringstream lines(progress_csv);
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> head = CellsOf(line);
  const auto found = std::find(head.begin(), head.end(), column);
  if (found == head.end()) throw std::runtime_error("progress.csv: no column " + column);
  const auto index = static_cast<std::size_t>(found - head.begin());
  Series series;
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = CellsOf(line);
    series.emplace_back(NumberIn(cells, 0), NumberIn(cells, index));
  }
  return series;
}

}  // namespace citrine::logs

#include "logs/metric_number.h"

#include <array>
#include <type_traits>

namespace citrine::logs {
namespace {

struct LabelRow {
  const char *key, *name, *unit;
  int decimals;
};

constexpr std::array kLabels = std::to_array<LabelRow>({
    {"makespan_m", "Makespan", "m", 1},
    {"average_path_m", "Av. path", "m", 1},
    {"coverage_pct", "Cov.", "%", 2},
    {"precision_pct", "Prec.", "%", 2},
    {"f_score_pct", "F-score", "%", 2},
    {"observable_coverage_pct", "Obs. cov.", "%", 2},
    {"goal_coverage_pct", "Goal cov.", "%", 2},
    {"object_goal_coverage_pct", "Object goal cov.", "%", 2},
    {"mission_time_s", "Time", "s", 1},
    {"wall_time_s", "Wall time", "s", 1},
    {"real_time_factor", "x real time", "", 1},
    {"mean_speed_mps", "Speed", "m/s", 2},
    {"surface_error_mean_m", "Error", "m", 3},
    {"surface_error_p95_m", "Error p95", "m", 3},
    {"voxels_reaching_goal_pct", "Voxels at goal", "%", 2},
    {"collisions", "Collisions", "", 0},
    {"min_obstacle_clearance_m", "Clearance", "m", 2},
    {"min_uav_separation_m", "Separation", "m", 2},
    {"decisions", "Decisions", "", 1},
    {"imbalance_corrections", "Corrections", "", 1},
    {"replan_ms_p50", "Decision p50", "ms", 2},
    {"replan_ms_p95", "Decision p95", "ms", 2},
    {"bus_bytes", "Bus", "B", 0},
    {"peak_memory_mb", "Memory", "MB", 0},
});

template <class T>
struct IsNumber : std::is_arithmetic<T> {};
template <class T>
struct IsNumber<std::optional<T>> : std::is_arithmetic<T> {};

struct Finder {
  const std::string& wanted;
  std::optional<double> found;

  template <class T>
  void operator()(const std::string& key, const T& value) {
    if constexpr (IsNumber<T>::value)
      if (key == wanted) Take(value);
  }

 private:
  template <class T>
  void Take(const T& value) {
    found = static_cast<double>(value);
  }
  template <class T>
  void Take(const std::optional<T>& value) {
    if (value) found = static_cast<double>(*value);
  }
};

struct KeyLister {
  std::vector<std::string> keys;

  template <class T>
  void operator()(const std::string& key, const T&) {
    if constexpr (IsNumber<T>::value) keys.push_back(key);
  }
};

}  // namespace

MetricLabel LabelOf(const std::string& key) {
  for (const LabelRow& row : kLabels)
    if (key == row.key) return {row.name, row.unit, row.decimals};
  return {key, "", 2};
}

std::string HeadOf(const std::string& key) {
  const MetricLabel label = LabelOf(key);
  return label.unit.empty() ? label.name : label.name + " (" + label.unit + ")";
}

std::optional<double> MetricNumber(const Metrics& metrics, const std::string& key) {
  Finder finder{key, std::nullopt};
  Metrics copy = metrics;
  copy.Visit(finder);
  return finder.found;
}

std::vector<std::string> NumberKeys() {
  KeyLister lister;
  Metrics metrics;
  metrics.Visit(lister);
  return lister.keys;
}

std::vector<std::string> PaperColumns() {
  return {"makespan_m",    "average_path_m",          "coverage_pct",      "precision_pct",
          "f_score_pct",   "observable_coverage_pct", "goal_coverage_pct", "object_goal_coverage_pct",
          "mission_time_s"};
}

}  // namespace citrine::logs

#include "logs/flight_measures.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace citrine::logs {
namespace {

constexpr Utime kAccelerationWindow_us = 100'000;

bool UnderWay(FlightStatus::Phase phase) {
  return phase == FlightStatus::Phase::kTracking || phase == FlightStatus::Phase::kBraking ||
         phase == FlightStatus::Phase::kBlocked;
}

}  // namespace

Series PathLengthOverTime(const std::vector<UavState>& states) {
  Series series;
  double length_m = 0;
  for (std::size_t k = 0; k < states.size(); ++k) {
    if (k > 0) length_m += (states[k].X_WB.p - states[k - 1].X_WB.p).norm();
    series.emplace_back(Seconds(states[k].utime), length_m);
  }
  return series;
}

double PathLength(const std::vector<UavState>& states) {
  return states.empty() ? 0.0 : PathLengthOverTime(states).back().second;
}

Series SpeedOverTime(const std::vector<UavState>& states) {
  Series series;
  for (const UavState& state : states) series.emplace_back(Seconds(state.utime), state.v_W.norm());
  return series;
}

Series AccelerationOverTime(const std::vector<UavState>& states) {
  Series series;
  std::size_t before = 0;
  for (const UavState& state : states) {
    while (state.utime - states[before].utime > kAccelerationWindow_us) ++before;
    const UavState& earlier = states[before];
    if (state.utime - earlier.utime < kAccelerationWindow_us) continue;
    series.emplace_back(Seconds(state.utime),
                        (state.v_W - earlier.v_W).norm() / Seconds(state.utime - earlier.utime));
  }
  return series;
}

std::vector<Series> SeparationOverTime(const std::vector<UavFlight>& uavs) {
  std::map<Utime, std::vector<std::pair<std::size_t, Eigen::Vector3d>>> positions_by_time;
  for (std::size_t i = 0; i < uavs.size(); ++i)
    for (const UavState& state : uavs[i].states) positions_by_time[state.utime].emplace_back(i, state.X_WB.p);
  std::vector<Series> separations(uavs.size());
  for (const auto& [utime, positions] : positions_by_time)
    for (const auto& [i, p_W] : positions) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& [other, other_W] : positions)
        if (other != i) nearest = std::min(nearest, (p_W - other_W).norm());
      if (std::isfinite(nearest)) separations[i].emplace_back(Seconds(utime), nearest);
    }
  return separations;
}

std::optional<double> MeanSpeedUnderWay(const std::vector<UavFlight>& uavs) {
  double sum = 0;
  std::size_t count = 0;
  for (const UavFlight& uav : uavs) {
    auto next = uav.flight_statuses.begin();
    bool under_way = false;
    for (const UavState& state : uav.states) {
      for (; next != uav.flight_statuses.end() && next->utime <= state.utime; ++next)
        under_way = UnderWay(next->value.phase);
      if (!under_way) continue;
      sum += state.v_W.norm();
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

Series ClearanceOverTime(const std::vector<UavState>& states, const Clearance& clearance) {
  Series series;
  for (const UavState& state : states) series.emplace_back(Seconds(state.utime), clearance(state.X_WB.p));
  return series;
}

int Collisions(const std::vector<UavFlight>& uavs) {
  int sum = 0;
  for (const UavFlight& uav : uavs) sum += uav.states.empty() ? 0 : uav.states.back().contacts;
  return sum;
}

std::int64_t Decisions(const std::vector<UavFlight>& uavs) {
  std::int64_t sum = 0;
  for (const UavFlight& uav : uavs) sum += uav.statuses.empty() ? 0 : uav.statuses.back().value.decisions;
  return sum;
}

int ElementsGivenUp(const std::vector<UavFlight>& uavs) {
  int most = 0;
  for (const UavFlight& uav : uavs)
    if (!uav.statuses.empty()) most = std::max(most, uav.statuses.back().value.elements_given_up);
  return most;
}

int ElementsUnreachable(const std::vector<UavFlight>& uavs) {
  int most = 0;
  for (const UavFlight& uav : uavs)
    if (!uav.statuses.empty()) most = std::max(most, uav.statuses.back().value.elements_unreachable);
  return most;
}

double ValueAt(const Series& series, double time_s) {
  const auto later = std::upper_bound(series.begin(), series.end(), time_s,
                                      [](double t, const auto& sample) { return t < sample.first; });
  return later == series.begin() ? 0.0 : std::prev(later)->second;
}

std::optional<double> MaxOf(const Series& series) {
  if (series.empty()) return std::nullopt;
  return std::max_element(series.begin(), series.end(), [](auto& a, auto& b) { return a.second < b.second; })
      ->second;
}

std::optional<double> MinOf(const Series& series) {
  if (series.empty()) return std::nullopt;
  return std::min_element(series.begin(), series.end(), [](auto& a, auto& b) { return a.second < b.second; })
      ->second;
}

std::optional<double> MinOf(const std::vector<Series>& all) {
  std::optional<double> least;
  for (const Series& series : all)
    if (const auto min = MinOf(series); min && (!least || *min < *least)) least = min;
  return least;
}

}  // namespace citrine::logs

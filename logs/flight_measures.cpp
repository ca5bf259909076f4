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

double NearestPair(const std::vector<Eigen::Vector3d>& positions) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < positions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, (positions[i] - positions[j]).norm());
  return nearest;
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

Series SeparationOverTime(const std::vector<UavFlight>& uavs) {
  std::map<Utime, std::vector<Eigen::Vector3d>> positions_by_time;
  for (const UavFlight& uav : uavs)
    for (const UavState& state : uav.states) positions_by_time[state.utime].push_back(state.X_WB.p);
  Series series;
  for (const auto& [utime, positions] : positions_by_time)
    if (positions.size() > 1) series.emplace_back(Seconds(utime), NearestPair(positions));
  return series;
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

std::optional<double> MinClearance(const std::vector<UavFlight>& uavs, const Clearance& clearance) {
  std::optional<double> least;
  for (const UavFlight& uav : uavs)
    for (const UavState& state : uav.states) {
      const double here = clearance(state.X_WB.p);
      if (!least || here < *least) least = here;
    }
  return least;
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

}  // namespace citrine::logs

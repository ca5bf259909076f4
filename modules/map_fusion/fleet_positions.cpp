#include "modules/map_fusion/fleet_positions.h"

#include <algorithm>
#include <cstdlib>

namespace citrine {
namespace {

constexpr Utime kKept_us = 1'000'000;

}  // namespace

void FleetPositions::Hear(int uav, const UavState& state) {
  std::deque<UavState>& states = states_[uav];
  states.push_back(state);
  while (states.front().utime < state.utime - kKept_us) states.pop_front();
}

std::vector<Eigen::Vector3d> FleetPositions::Others(int uav, Utime time) const {
  std::vector<Eigen::Vector3d> others;
  for (const auto& [other, states] : states_) {
    if (other == uav) continue;
    const auto nearest =
        std::min_element(states.begin(), states.end(), [&](const UavState& a, const UavState& b) {
          return std::abs(a.utime - time) < std::abs(b.utime - time);
        });
    others.push_back(nearest->X_WB.p + nearest->v_W * Seconds(time - nearest->utime));
  }
  return others;
}

}  // namespace citrine

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/quality/mission_progress.h"
#include "core/vehicle/uav_state.h"
#include "modules/codec/clock.h"

namespace citrine {

/// What somebody who looks on knows of a mission.
/// Hears: CLOCK, MISSION_PROGRESS, UAV*_STATE, UAV*_FLEET_STATUS.
struct MissionView {
  struct Uav {
    std::optional<UavState> state;
    double path_m = 0;
    double speed_mps = 0;
    bool has_goal = false;
    std::int32_t elements_unreachable = 0, elements_given_up = 0;
  };
  static constexpr const char* kChannels = "CLOCK|MISSION_PROGRESS|UAV[0-9]+_(STATE|FLEET_STATUS)";

  std::string mission_id;  ///< others are not listened to
  std::optional<Clock> clock;
  MissionProgress progress;
  std::vector<Uav> uavs;  ///< index: id - 1

  bool done() const { return clock && clock->state == Clock::State::kDone; }

  /// Takes over one message; those of other channels, and nonsense, say nothing.
  void Hear(const std::string& channel, const void* bytes, int size);
};

}  // namespace citrine

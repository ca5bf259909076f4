#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/config/mission_config.h"
#include "modules/runtime/bus.h"

namespace citrine {

/// Counts mission time and says it: one CLOCK a step.
class ClockOwner {
 public:
  /// @param bus of the module that owns the time
  ClockOwner(const MissionConfig& config, Bus& bus) : config_(config), bus_(bus) {}

  /// Begins the next step on the owner's bus and says CLOCK; with a reason to stop, the last.
  Step Advance(const std::optional<std::string>& stop_reason, bool lockstep);
  /// Says the same CLOCK again, for who missed it.
  void Repeat();

 private:
  const MissionConfig& config_;
  Bus& bus_;
  std::int64_t next_ = 0;
  std::vector<std::uint8_t> clock_;
};

}  // namespace citrine

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <citrine_lcm/module_health_t.hpp>

#include "core/time.h"

namespace citrine {

/// How a module is: wall times and counts, read by no decision.
struct ModuleHealth {
  enum class State : std::int8_t { kStarting = 0, kRunning = 1, kDone = 2 };

  std::string name;
  int uav = 0;  ///< 1..N in a module that serves one UAV, else 0
  State state = State::kStarting;
  Utime last_tick = 0;
  double worst_tick_ms = 0;  ///< since the last one of these
  std::int64_t lost = 0;     ///< messages, since the module began
  std::int64_t bad = 0;
  std::int64_t bytes_said = 0;
  std::int64_t peak_memory_kb = 0;  ///< of the module's process
  std::string last_error;
  std::map<std::string, std::vector<float>> samples;  ///< since the last one of these
};

citrine_lcm::module_health_t Encode(const ModuleHealth& health);

/// @throws BadMessage for an unknown state, or counts that do not agree
ModuleHealth Decode(const citrine_lcm::module_health_t& message);

}  // namespace citrine

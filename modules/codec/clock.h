#pragma once

#include <cstdint>
#include <string>

#include <citrine_lcm/clock_t.hpp>

#include "core/time.h"

namespace citrine {

/// Mission time as its owner says it, once a step.
struct Clock {
  enum class State : std::int8_t { kRunning = 0, kDone = 1 };

  Utime utime = 0;
  std::int64_t step = 0;
  double dt_s = 0;
  double pace = 0;  ///< mission seconds a second of the wall; 0: lockstep
  State state = State::kRunning;
  std::string mission_id;
  std::string reason;  ///< why it is done (metrics.json: stop_reason); empty while it runs
};

citrine_lcm::clock_t Encode(const Clock& clock);

/// @throws BadMessage for an impossible step, dt or state
Clock Decode(const citrine_lcm::clock_t& message);

}  // namespace citrine

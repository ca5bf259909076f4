#pragma once

#include <cstdint>
#include <map>
#include <string>

#include <citrine_lcm/step_done_t.hpp>

#include "core/time.h"

namespace citrine {

/// What a module said in a step of a lockstep mission.
struct StepDone {
  std::int64_t step = 0;
  std::string module;
  int uav = 0;                                   ///< 1..N in a module that serves one UAV, else 0
  std::map<std::string, std::int64_t> last_seq;  ///< by channel on which it spoke in this step
};

citrine_lcm::step_done_t Encode(const StepDone& done);

/// @throws BadMessage if the counts do not agree or a channel is named twice
StepDone Decode(const citrine_lcm::step_done_t& message);

}  // namespace citrine

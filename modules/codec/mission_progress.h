#pragma once

#include <citrine_lcm/mission_progress_t.hpp>

#include "core/quality/mission_progress.h"

namespace citrine {

citrine_lcm::mission_progress_t Encode(const MissionProgress& progress);

/// @throws BadMessage for a count below 0 or a share that is none
MissionProgress Decode(const citrine_lcm::mission_progress_t& message);

}  // namespace citrine

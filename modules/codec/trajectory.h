#pragma once

#include <citrine_lcm/trajectory_t.hpp>

#include "core/trajectory/trajectory.h"

namespace citrine {

citrine_lcm::trajectory_t Encode(const Trajectory& trajectory);

/// @throws BadMessage without segments, or for one without duration or with a coefficient that is not finite
Trajectory Decode(const citrine_lcm::trajectory_t& message);

}  // namespace citrine

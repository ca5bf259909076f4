#pragma once

#include <citrine_lcm/fleet_status_t.hpp>

#include "core/fleet/fleet_status.h"

namespace citrine {

citrine_lcm::fleet_status_t Encode(const FleetStatus& status);

/// @throws BadMessage for a pose or goal that is none, a count below 0 or an unknown activity
FleetStatus Decode(const citrine_lcm::fleet_status_t& message);

}  // namespace citrine

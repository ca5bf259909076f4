#pragma once

#include <citrine_lcm/fleet_assignment_t.hpp>

#include "core/fleet/fleet_status.h"

namespace citrine {

citrine_lcm::fleet_assignment_t Encode(const FleetAssignment& assignment);

/// @throws BadMessage for a centroid that is not finite, or a sender outside the fleet
FleetAssignment Decode(const citrine_lcm::fleet_assignment_t& message);

}  // namespace citrine

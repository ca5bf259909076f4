#pragma once

#include <citrine_lcm/flight_status_t.hpp>

#include "core/fleet/fleet_status.h"

namespace citrine {

citrine_lcm::flight_status_t Encode(const FlightStatus& status);

/// @throws BadMessage for an unknown phase or a number that is none
FlightStatus Decode(const citrine_lcm::flight_status_t& message);

}  // namespace citrine

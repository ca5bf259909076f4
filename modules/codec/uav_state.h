#pragma once

#include <citrine_lcm/uav_state_t.hpp>

#include "core/vehicle/uav_state.h"

namespace citrine {

citrine_lcm::uav_state_t Encode(const UavState& state);

/// @throws BadMessage for a pose or velocity that is none
UavState Decode(const citrine_lcm::uav_state_t& message);

}  // namespace citrine

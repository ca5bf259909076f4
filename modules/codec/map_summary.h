#pragma once

#include <citrine_lcm/map_summary_t.hpp>

#include "core/map/map_block.h"

namespace citrine {

citrine_lcm::map_summary_t Encode(const MapSummary& summary);

/// @throws BadMessage for a grid that cannot be, or is larger than any mission's
MapSummary Decode(const citrine_lcm::map_summary_t& message);

}  // namespace citrine

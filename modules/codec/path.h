#pragma once

#include <citrine_lcm/path_t.hpp>

#include "core/trajectory/path.h"

namespace citrine {

citrine_lcm::path_t Encode(const Path& path);

/// @throws BadMessage for a waypoint that is not finite, or limits that nobody can keep
Path Decode(const citrine_lcm::path_t& message);

}  // namespace citrine

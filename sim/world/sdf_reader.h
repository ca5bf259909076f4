#pragma once

#include <string>
#include <vector>

#include "sim/world/world.h"

namespace citrine::sim {

/// Reads the shapes of every model of an SDFormat file: its collisions, and the visuals of a link that has
/// none.
/// @param search  folders in which model://NAME is looked for, in order
/// @return parts and mesh; bounds and hash are left to Finish()
/// @throws WorldError
World ReadSdf(const std::string& path, const std::vector<std::string>& search);

}  // namespace citrine::sim

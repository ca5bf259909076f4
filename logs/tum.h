#pragma once

#include <string>
#include <vector>

#include "core/vehicle/uav_state.h"

namespace citrine::logs {

/// A trajectory in the format of the TUM RGB-D benchmark (Sturm et al. 2012): a line `t x y z qx qy qz qw` a
/// state; seconds of mission time and metres with six decimals, body in world.
std::string ToTum(const std::vector<UavState>& states);

}  // namespace citrine::logs

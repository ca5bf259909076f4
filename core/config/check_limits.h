#pragma once

#include "core/config/mission_config.h"

namespace citrine {

/// Checks what no single key can: limits that contradict each other.
/// @throws ConfigError naming both keys and their values
void CheckLimits(const MissionConfig& config);

}  // namespace citrine

#pragma once

#include <string>
#include <vector>

#include "core/config/mission_config.h"

namespace citrine {

/// Reads a mission file's text. @param overrides "section.key=value", later ones win
/// @throws ConfigError naming the key's full path, its value and what is allowed, for an unknown key (with
/// the nearest
///         known one), a wrong type, a value out of range, or limits that contradict each other; and, with
///         line and column, for text that is not TOML.
MissionConfig ParseMission(const std::string& toml_text, const std::vector<std::string>& overrides);

/// Every key as a TOML text that ParseMission reads back to the same configuration.
std::string ToToml(const MissionConfig& config);

/// The table that `citrine config` prints: key, unit, range, default, meaning.
std::string DescribeKeys();

}  // namespace citrine

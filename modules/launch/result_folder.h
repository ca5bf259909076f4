#pragma once

#include <string>

#include "modules/launch/mission_resolver.h"
#include "modules/runtime/log_parts.h"

namespace citrine {

/// Makes the mission's result folder, takes away the results of an earlier mission, and writes the resolved
/// mission.toml. Files of other names stay. @return the mission file's path
/// @throws std::filesystem::filesystem_error, std::runtime_error if it cannot be written
std::string PrepareResultFolder(const ResolvedMission& mission);

/// How the mission's log is split.
LogSplit SplitOf(const LaunchSection& launch);

}  // namespace citrine

#pragma once

#include <string>
#include <vector>

#include "core/config/mission_config.h"
#include "modules/launch/supervisor.h"
#include "modules/runtime/log_parts.h"

namespace citrine {

inline constexpr const char* kTimeOwner = "uav_dynamics";
inline constexpr const char* kRecorder = "recorder";

/// What writes all that is said to `log`; probes of the bus are left out.
ProcessSpec RecorderProcess(const std::string& url, const std::string& log, const LogSplit& split);

/// THE LIST of what flies a mission as separate processes, the owner of time last: the others hear its first
/// CLOCK.
/// @param mission_file the resolved mission
std::vector<ProcessSpec> ModuleProcesses(const MissionConfig& config, const std::string& mission_file,
                                         const std::string& url);

}  // namespace citrine

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/config/mission_config.h"
#include "modules/runtime/log_event.h"
#include "modules/runtime/module_kind.h"

namespace citrine {

/// What a module did when it heard a recording.
struct Replayed {
  std::vector<LogEvent> said;  ///< in canonical order (LogEvent); see SaidBy
  std::string error;           ///< of a module that died, in one line
  std::int64_t steps = 0;
};

/// Feeds a recording into one real module, in this process: at each recorded CLOCK it has heard what was said
/// in the steps before, by everyone but itself. Its own words it hears from itself.
/// @param events in canonical order  @param uav that it serves, 0 if it serves all
/// @param speed mission seconds a second of the wall; 0: as fast as it goes
/// @param interrupted asked once a step: whether a person has had enough
/// @throws what the module's constructor throws
Replayed Replay(const std::vector<LogEvent>& events, const MissionConfig& config, const ModuleKind& kind,
                int uav, double speed = 0, const std::function<bool()>& interrupted = nullptr);

}  // namespace citrine

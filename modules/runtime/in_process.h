#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/config/mission_config.h"
#include "modules/runtime/log_event.h"
#include "modules/runtime/module_kind.h"

namespace citrine {

/// What a mission in one process asks of whoever started it; every member may be empty.
struct InProcessCallbacks {
  /// Every message, those of one step together, in canonical order (LogEvent): for a LogWriter, a LogDigest,
  /// a progress line.
  std::function<void(const LogEvent& event)> on_event;
  /// Asked once a step: whether a person wants the mission to end.
  std::function<bool()> interrupted;
  /// What the starter itself says before the first step, such as MISSION_CONFIG.
  std::function<void(Bus& bus)> say_first;
};

struct InProcessResult {
  std::string stop_reason;  ///< as in metrics.json
  std::string error;        ///< of a module that died, in one line
  std::int64_t steps = 0;   ///< CLOCK messages, the last included
  Utime mission_time = 0;   ///< of the last
};

/// Flies a mission in this process and thread: all modules on one memq bus, in lockstep, paced by
/// launch.pace. The same configuration gives the same events, bit for bit, and those of as many processes in
/// lockstep.
/// @param kinds of modules; exactly one owns the time; a kind that serves one UAV is made once for each
/// @param world  the mission's, if the caller holds it; null: each module that needs it reads it
/// @throws what a module's constructor throws, std::invalid_argument if none or several own the time
InProcessResult RunInProcess(const MissionConfig& config, const std::vector<ModuleKind>& kinds,
                             const InProcessCallbacks& callbacks,
                             const std::shared_ptr<const sim::World>& world = nullptr);

}  // namespace citrine

#pragma once

#include <optional>
#include <string>

#include "modules/launch/mission_resolver.h"

namespace citrine {

/// How a mission ended, as far as the one who started it can tell.
struct Flight {
  std::string stop_reason;  ///< as in metrics.json
  double wall_time_s = 0;
  std::optional<std::string> death;  ///< the module that died, and how
};

/// Flies in processes of their own, on the bus at `url`; <out>/mission.lcmlog is there afterwards.
/// @param by_hand somebody else starts the modules; this says how, records, and waits for the end
/// @throws std::runtime_error for what cannot be started
Flight FlyInProcesses(const ResolvedMission& mission, const std::string& mission_file, const std::string& url,
                      bool by_hand = false);

/// Flies in this process, in lockstep; the log is the same.
Flight FlyInProcess(const ResolvedMission& mission);

}  // namespace citrine

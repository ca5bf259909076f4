#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "logs/flight_record.h"
#include "modules/codec/mission_config_text.h"
#include "modules/runtime/log_event.h"

namespace citrine {

/// What a log says about its mission.
struct Recording {
  logs::FlightRecord flight;
  std::optional<MissionConfigText> config;  ///< as it was flown
  std::string stop_reason;        ///< of the last CLOCK; empty if the log ends before the mission did
  std::int64_t messages_bad = 0;  ///< that did not decode here
  std::map<std::string, std::int64_t> peak_memory_kb_by_module;
};

/// Goes through the events of a log; what does not decode is left out and counted.
Recording ReadRecording(const std::vector<LogEvent>& events);

}  // namespace citrine

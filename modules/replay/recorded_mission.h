#pragma once

#include <string>
#include <vector>

#include "core/config/mission_config.h"
#include "modules/codec/mission_config_text.h"
#include "modules/runtime/log_event.h"
#include "modules/runtime/log_reader.h"

namespace citrine {

/// A mission as a log tells it.
struct RecordedMission {
  MissionConfig config;  ///< as it was flown
  MissionConfigText flown;
  std::vector<LogEvent> events;  ///< in canonical order (LogEvent)
  RecordingFlaws flaws;
};

/// @throws std::runtime_error if the log cannot be read or does not say which mission it is of, ConfigError
RecordedMission ReadMission(const std::string& log_path);

}  // namespace citrine

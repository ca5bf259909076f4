#pragma once

#include <functional>
#include <string>

#include "modules/runtime/log_event.h"

namespace citrine {

/// Where a tool hears messages: in a log if one is named, else on a bus.
struct SourceOptions {
  std::string log;  ///< a log or a result folder
  std::string run;  ///< result folder of a mission under way, whose bus is meant, isolated or not
  std::string url;  ///< of a bus; empty: the default
};

/// A log, or the log of a result folder; split ones by the name without the part's number.
/// @throws std::runtime_error if it is not there
std::string FindLog(const std::string& folder_or_log);

/// URL of the bus that is meant, which can be heard; with `run` this process has moved to its network.
/// @throws std::runtime_error as EnterRunningMission and RequireHeard
std::string FindBus(const SourceOptions& options);

/// Hands every message of a log to `hear`, in the order of the file, without what the bus says of itself;
/// says on stderr how many damaged places it skipped.
void HearLog(const std::string& log, const std::function<void(const LogEvent&)>& hear);

/// Hands every message on a bus to `hear` as it comes, and calls `look` at least every 100 ms, until that
/// returns false or, with `run`, the mission is over.
/// @param url of FindBus(options)  @throws std::runtime_error if the bus cannot be used
void HearBus(const SourceOptions& options, const std::string& url,
             const std::function<void(const LogEvent&)>& hear, const std::function<bool()>& look);

}  // namespace citrine

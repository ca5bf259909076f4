#pragma once

#include <functional>
#include <vector>

#include "modules/runtime/log_event.h"
#include "modules/runtime/transport.h"

namespace citrine {

/// Says a recording on a bus, as it is and in its own time.
/// @param speed mission seconds a second of the wall
/// @param on_event called with what has just been said; @return false to end
void Play(const std::vector<LogEvent>& events, Transport& transport, double speed,
          const std::function<bool(const LogEvent& event)>& on_event);

}  // namespace citrine

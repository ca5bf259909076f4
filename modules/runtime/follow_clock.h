#pragma once

#include "modules/runtime/hosted_module.h"

namespace citrine {

/// The run loop of every other process: announces itself, ticks when CLOCK says so, and ends with the mission
/// or a signal.
void FollowClock(HostedModule& module);

}  // namespace citrine

#pragma once

#include "modules/runtime/hosted_module.h"

namespace citrine {

/// The run loop of the process that owns the time: waits for the others, says CLOCK step by step, and ends
/// the mission when its module or a signal says so.
void OwnClock(HostedModule& module);

}  // namespace citrine

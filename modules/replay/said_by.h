#pragma once

#include "modules/runtime/log_event.h"
#include "modules/runtime/module_id.h"

namespace citrine {

/// Whether a recorded message was said by this module, by the channel table (lcmtypes/README.md). What all
/// modules say of themselves is nobody's here: MODULE_HEALTH carries wall time, STEP_DONE only counts.
bool SaidBy(const ModuleId& module, const LogEvent& event);

/// Whether this is a choice, from which on two missions may go different ways: what planners and smoothers
/// say.
bool IsDecision(const LogEvent& event);

}  // namespace citrine

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "modules/runtime/bus.h"
#include "modules/runtime/module_id.h"

namespace citrine {

/// Lockstep among processes: who has finished which step, and whether all that they said in it has come.
class StepBarrier {
 public:
  /// Hears STEP_DONE on `bus`, which must outlive it.
  StepBarrier(Bus& bus, std::vector<ModuleId> modules);

  /// Those who have not said that they are done with a step.
  std::vector<ModuleId> NotDone(std::int64_t step) const;
  /// Whether all are done with a step and what they named has come.
  bool Complete(std::int64_t step);
  /// Counts what was named and has not come as lost.
  void GiveUpWaiting();

 private:
  Bus& bus_;
  const std::vector<ModuleId> modules_;
  std::map<ModuleId, std::int64_t> done_;
  std::map<std::pair<std::string, int>, std::int64_t> missing_;  ///< seq by channel and UAV of the sender
};

}  // namespace citrine

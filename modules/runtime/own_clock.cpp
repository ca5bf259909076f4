#include "modules/runtime/own_clock.h"

#include <cmath>
#include <cstdio>
#include <set>

#include "modules/channels.h"
#include "modules/runtime/clock_owner.h"
#include "modules/runtime/quit_signals.h"
#include "modules/runtime/step_barrier.h"
#include "modules/runtime/wall_pacer.h"

namespace citrine {
namespace {

constexpr double kNameMissing_ms = 10000;  // who has not announced itself by then is named
constexpr double kNameLate_ms = 5000;      // who keeps the others waiting in lockstep is named
constexpr double kRepeat_ms = 500;         // a CLOCK or STEP_DONE that was lost costs this
constexpr double kLostAfter_ms = 200;      // what was named in STEP_DONE and has not come by then will not
constexpr double kLastStep_ms = 60000;     // for the others to write their files
constexpr double kLastWhenInterrupted_ms = 10000;
constexpr int kDoneRepeats = 10;  // of the last CLOCK where nobody acknowledges it, 100 ms apart

/// Hears who is there, from MODULE_HEALTH.
class RollCall {
 public:
  explicit RollCall(Bus& bus) {
    bus.HearBytes(channels::kModuleHealth.name, [this](const std::string&, const void* bytes, int size) {
      citrine_lcm::module_health_t message{};
      try {
        if (message.decode(bytes, 0, size) == size) present_.insert({message.module, message.uav});
      } catch (const std::exception&) {
        return;  // whoever it was has not announced itself
      }
    });
  }
  std::vector<ModuleId> Absent(const std::vector<ModuleId>& expected) const {
    std::vector<ModuleId> absent;
    for (const ModuleId& id : expected)
      if (!present_.contains(id)) absent.push_back(id);
    return absent;
  }

 private:
  std::set<ModuleId> present_;
};

void AwaitAll(HostedModule& module, const RollCall& roll, const std::vector<ModuleId>& expected) {
  const Stopwatch since;
  for (bool named = false; !Interrupted();) {
    module.SayHealthWhenDue(ModuleHealth::State::kStarting);
    module.bus().Handle(100);
    const auto absent = roll.Absent(expected);
    if (absent.empty()) return;
    if (named || since.ms() < kNameMissing_ms) continue;
    named = true;
    std::fprintf(stderr, "%s: waits for %s\n", module.id().name.c_str(), ToText(absent).c_str());
  }
}

/// Waits until all are done with a step, or there is no sense in waiting.
void Gather(HostedModule& module, ClockOwner& clock, StepBarrier& barrier, const Step& step) {
  const Stopwatch since;
  Stopwatch since_repeat, since_all_done;
  for (bool named = false; !barrier.Complete(step.index);) {
    module.bus().Handle(step.last ? 50 : 5);
    const auto late = barrier.NotDone(step.index);
    if (!late.empty())
      since_all_done = {};
    else if (since_all_done.ms() > kLostAfter_ms)
      return barrier.GiveUpWaiting();
    if (Terminated() || (!step.last && Interrupted())) return;
    if (step.last && since.ms() > (Interrupted() ? kLastWhenInterrupted_ms : kLastStep_ms)) return;
    if (since_repeat.ms() > kRepeat_ms) {
      clock.Repeat();
      since_repeat = {};
    }
    module.SayHealthWhenDue();
    if (named || late.empty() || since.ms() < kNameLate_ms) continue;
    named = true;
    std::fprintf(stderr, "%s: step %lld waits for %s\n", module.id().name.c_str(),
                 static_cast<long long>(step.index), ToText(late).c_str());
  }
}

void AwaitWall(HostedModule& module, WallPacer& pacer) {
  pacer.EndStep();
  module.bus().Handle(0);
  while (pacer.left_ms() > 0 && !Terminated())
    module.bus().Handle(static_cast<int>(std::ceil(pacer.left_ms())));
}

}  // namespace

void OwnClock(HostedModule& module) {
  const bool lockstep = module.config().lockstep();
  const std::vector<ModuleId> modules = ModulesOf(module.config());
  StepBarrier barrier(module.bus(), modules);
  const RollCall roll(module.bus());
  AwaitAll(module, roll, modules);
  ClockOwner clock(module.config(), module.bus());
  WallPacer pacer(module.config().launch.pace, module.config().dynamics.step_s);
  module.SayHealth(ModuleHealth::State::kRunning);
  for (std::optional<std::string> reason;;) {
    const Step step = clock.Advance(reason, lockstep);
    module.Tick(step);
    if (lockstep) module.SayStepDone(step);
    module.SayHealthWhenDue();
    if (lockstep)
      Gather(module, clock, barrier, step);
    else if (!step.last)
      AwaitWall(module, pacer);
    if (step.last) break;
    reason = Interrupted() ? "interrupted" : module.stop_reason();
  }
  for (int i = 0; i < kDoneRepeats && !lockstep; ++i) {
    clock.Repeat();
    module.bus().Handle(100);
  }
}

}  // namespace citrine

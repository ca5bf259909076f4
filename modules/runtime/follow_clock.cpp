#include "modules/runtime/follow_clock.h"

#include <deque>

#include "modules/channels.h"
#include "modules/codec/bad_message.h"
#include "modules/codec/clock.h"
#include "modules/runtime/quit_signals.h"
#include "modules/runtime/step_barrier.h"

namespace citrine {
namespace {

constexpr int kWait_ms = 200;              // for a message, before it looks for signals again
constexpr double kLostAfter_ms = 200;      // what was named in STEP_DONE and has not come by then will not
constexpr double kOwnerAnswers_ms = 2000;  // an interrupted owner of time has said the last CLOCK by then

/// CLOCK of one mission, as it comes.
class ClockHearer {
 public:
  explicit ClockHearer(HostedModule& module) {
    module.bus().HearBytes(channels::kClock.name,
                           [this, &module](const std::string& channel, const void* bytes, int size) {
                             citrine_lcm::clock_t message{};
                             try {
                               Require(message.decode(bytes, 0, size) == size, "another type or cut short");
                               const Clock clock = Decode(message);
                               if (mission_id_.empty()) mission_id_ = clock.mission_id;
                               Require(clock.mission_id == mission_id_, "another mission is on this bus");
                               waiting_.push_back(clock);
                             } catch (const std::exception& error) {
                               module.bus().Reject(channel, error.what());
                             }
                           });
  }

  /// The next CLOCK, or, where nobody waits for this module, the newest.
  std::optional<Clock> Take(bool lockstep) {
    if (waiting_.empty()) return std::nullopt;
    const Clock clock = lockstep ? waiting_.front() : waiting_.back();
    if (lockstep)
      waiting_.pop_front();
    else
      waiting_.clear();
    return clock;
  }

 private:
  std::deque<Clock> waiting_;
  std::string mission_id_;
};

/// Waits for what was said in a step until it is there or lost.
void CatchUp(Bus& bus, StepBarrier& barrier, std::int64_t step) {
  for (const Stopwatch since; !barrier.Complete(step) && since.ms() < kLostAfter_ms;) bus.Handle(10);
  barrier.GiveUpWaiting();
}

void TickOnce(HostedModule& module, StepBarrier& barrier, const Step& step) {
  const bool lockstep = module.config().lockstep();
  if (lockstep && step.index > 0) CatchUp(module.bus(), barrier, step.index - 1);
  module.Begin(step, lockstep);
  module.Tick(step);
  if (lockstep) module.SayStepDone(step);
  module.SayHealthWhenDue();
}

}  // namespace

void FollowClock(HostedModule& module) {
  const bool lockstep = module.config().lockstep();
  ClockHearer clocks(module);
  StepBarrier barrier(module.bus(), ModulesOf(module.config()));
  std::optional<Step> step;
  std::optional<Stopwatch> since_interrupt;
  const auto abandoned = [&] {
    if (Interrupted() && !since_interrupt) since_interrupt.emplace();
    return Terminated() || (since_interrupt && since_interrupt->ms() > kOwnerAnswers_ms);
  };
  while (!(step && step->last) && !abandoned()) {
    if (!step) module.SayHealthWhenDue(ModuleHealth::State::kStarting);
    module.bus().Handle(kWait_ms);
    while (const auto clock = clocks.Take(lockstep)) {
      if (step && clock->step <= step->index) {
        if (lockstep && clock->step == step->index) module.RepeatStepDone();
        continue;
      }
      if (!step) module.SayHealth(ModuleHealth::State::kRunning);
      step = Step{clock->step, clock->utime, clock->state == Clock::State::kDone};
      TickOnce(module, barrier, *step);
      if (step->last || Terminated()) break;
    }
    if (step) module.SayHealthWhenDue();
  }
  if (step && step->last && lockstep)
    module.RepeatStepDone();  // nobody will be here to answer if it was lost
  if (!step || step->last) return;
  step->last = true;
  module.Begin(*step, lockstep);
  module.Tick(*step);
}

}  // namespace citrine

#include "modules/runtime/clock_owner.h"

#include "modules/channels.h"
#include "modules/codec/clock.h"
#include "modules/runtime/module_id.h"

namespace citrine {

Step ClockOwner::Advance(const std::optional<std::string>& stop_reason, bool lockstep) {
  const double dt_s = config_.dynamics.step_s;
  const Step step{next_, FromSeconds(static_cast<double>(next_) * dt_s), stop_reason.has_value()};
  ++next_;
  bus_.BeginStep(step, lockstep);
  Clock clock{
      step.now,           step.index, dt_s, lockstep ? 0 : config_.launch.pace, Clock::State::kRunning,
      MissionId(config_), {}};
  if (stop_reason) {
    clock.state = Clock::State::kDone;
    clock.reason = *stop_reason;
  }
  citrine_lcm::clock_t message = Encode(clock);
  bus_.Publish(channels::kClock, message);
  message.seq = bus_.last_said().at(channels::kClock.name);
  clock_ = Bus::ToBytes(message);
  return step;
}

void ClockOwner::Repeat() { bus_.SayBytes(channels::kClock.name, clock_); }

}  // namespace citrine

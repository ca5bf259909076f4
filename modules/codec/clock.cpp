#include "modules/codec/clock.h"

#include "modules/codec/bad_message.h"

namespace citrine {

citrine_lcm::clock_t Encode(const Clock& clock) {
  citrine_lcm::clock_t message{};
  message.utime = clock.utime;
  message.step = clock.step;
  message.dt_s = clock.dt_s;
  message.pace = clock.pace;
  message.state = static_cast<std::int8_t>(clock.state);
  message.mission_id = clock.mission_id;
  message.reason = clock.reason;
  return message;
}

Clock Decode(const citrine_lcm::clock_t& message) {
  RequireFinite("clock_t: dt_s or pace is not a number", message.dt_s, message.pace);
  Require(message.step >= 0 && message.utime >= 0, "clock_t: time before the mission");
  Require(message.dt_s > 0 && message.pace >= 0, "clock_t: dt_s or pace out of range");
  Require(message.state == message.RUNNING || message.state == message.DONE, "clock_t: unknown state");
  return {
      message.utime,      message.step,  message.dt_s, message.pace, static_cast<Clock::State>(message.state),
      message.mission_id, message.reason};
}

}  // namespace citrine

#include "modules/codec/step_done.h"

#include "modules/codec/bad_message.h"

namespace citrine {

citrine_lcm::step_done_t Encode(const StepDone& done) {
  citrine_lcm::step_done_t message{};
  message.step = done.step;
  message.uav = done.uav;
  message.module = done.module;
  message.num_channels = static_cast<std::int32_t>(done.last_seq.size());
  for (const auto& [channel, seq] : done.last_seq) {
    message.channels.push_back(channel);
    message.last_seq.push_back(seq);
  }
  return message;
}

StepDone Decode(const citrine_lcm::step_done_t& message) {
  Require(message.step >= 0 && message.uav >= 0 && !message.module.empty(),
          "step_done_t: says nobody or no step");
  StepDone done{message.step, message.module, message.uav, {}};
  for (std::int32_t i = 0; i < message.num_channels; ++i)
    done.last_seq[message.channels[i]] = message.last_seq[i];
  Require(done.last_seq.size() == message.channels.size(), "step_done_t: a channel is named twice");
  return done;
}

}  // namespace citrine

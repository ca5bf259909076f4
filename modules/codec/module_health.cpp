#include "modules/codec/module_health.h"

#include <numeric>

#include "modules/codec/bad_message.h"

namespace citrine {

citrine_lcm::module_health_t Encode(const ModuleHealth& health) {
  citrine_lcm::module_health_t message{};
  message.last_tick_utime = health.last_tick;
  message.worst_tick_ms = health.worst_tick_ms;
  message.messages_lost = health.lost;
  message.messages_bad = health.bad;
  message.bytes_said = health.bytes_said;
  message.peak_memory_kb = health.peak_memory_kb;
  message.uav = health.uav;
  message.state = static_cast<std::int8_t>(health.state);
  message.module = health.name;
  message.last_error = health.last_error;
  message.num_names = static_cast<std::int32_t>(health.samples.size());
  for (const auto& [name, values] : health.samples) {
    message.sample_names.push_back(name);
    message.num_samples.push_back(static_cast<std::int32_t>(values.size()));
    message.sample_values.insert(message.sample_values.end(), values.begin(), values.end());
  }
  message.num_values = static_cast<std::int32_t>(message.sample_values.size());
  return message;
}

ModuleHealth Decode(const citrine_lcm::module_health_t& message) {
  Require(message.state >= message.STARTING && message.state <= message.DONE,
          "module_health_t: unknown state");
  Require(!message.module.empty() && message.uav >= 0, "module_health_t: says nobody");
  ModuleHealth health{message.module,
                      message.uav,
                      static_cast<ModuleHealth::State>(message.state),
                      message.last_tick_utime,
                      message.worst_tick_ms,
                      message.messages_lost,
                      message.messages_bad,
                      message.bytes_said,
                      message.peak_memory_kb,
                      message.last_error,
                      {}};
  std::int64_t next = 0;
  for (std::int32_t i = 0; i < message.num_names; ++i) {
    const std::int64_t count = message.num_samples[i];
    Require(count >= 0 && next + count <= message.num_values,
            "module_health_t: num_samples exceeds num_values");
    const auto first = message.sample_values.begin() + next;
    health.samples[message.sample_names[i]].assign(first, first + count);
    next += count;
  }
  Require(next == message.num_values, "module_health_t: num_values exceeds num_samples");
  return health;
}

}  // namespace citrine

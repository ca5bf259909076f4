#include "modules/codec/strategy_message.h"

#include "modules/codec/bad_message.h"

namespace citrine {

citrine_lcm::strategy_message_t Encode(const StrategyMessage& noun) {
  citrine_lcm::strategy_message_t message{};
  message.from = noun.from;
  message.to = noun.to;
  message.kind = noun.kind;
  message.num_bytes = static_cast<std::int32_t>(noun.bytes.size());
  message.data = noun.bytes;
  return message;
}

StrategyMessage Decode(const citrine_lcm::strategy_message_t& message) {
  Require(message.from >= 1 && message.to >= 0, "strategy_message_t: from or to is no UAV");
  return {message.from, message.to, message.kind, message.data};
}

}  // namespace citrine

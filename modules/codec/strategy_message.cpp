#include "modules/codec/strategy_message.h"

#include "modules/codec/bad_message.h"

namespace citrine {

citrine_lcm::strategy_message_t Encode(const StrategyMessage& noun) {
  citrine_lcm::strategy_message_t message{};
  message.from_uav = noun.from_uav;
  message.to_uav = noun.to_uav;
  message.kind = noun.kind;
  message.num_bytes = static_cast<std::int32_t>(noun.bytes.size());
  message.data = noun.bytes;
  return message;
}

StrategyMessage Decode(const citrine_lcm::strategy_message_t& message) {
  Require(message.from_uav >= 1 && message.to_uav >= 0, "strategy_message_t: sender or addressee is no UAV");
  return {message.from_uav, message.to_uav, message.kind, message.data};
}

}  // namespace citrine

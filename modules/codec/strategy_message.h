#pragma once

#include <citrine_lcm/strategy_message_t.hpp>

#include "core/fleet/strategy_message.h"

namespace citrine {

citrine_lcm::strategy_message_t Encode(const StrategyMessage& noun);

/// @throws BadMessage for a sender or addressee that is no UAV
StrategyMessage Decode(const citrine_lcm::strategy_message_t& message);

}  // namespace citrine

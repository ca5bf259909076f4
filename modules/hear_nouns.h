#pragma once

#include <limits>

#include "modules/codec/bad_message.h"
#include "modules/runtime/bus.h"

namespace citrine {

/// Hands every message of an inbox to `take(noun, utime)`, in order; what means nothing is dropped and
/// counted (Bus::Reject), also when `take` itself throws BadMessage.
template <class Message, class Take>
void HearNouns(Bus& bus, const Channel<Message>& channel, Inbox<Message>& inbox, const Take& take) {
  for (const auto& [nobody, message] : inbox.Take()) {
    try {
      take(Decode(message), message.utime);
    } catch (const BadMessage& error) {
      bus.Reject(channel.name, error.what());
    }
  }
}

inline constexpr int kEveryUav = std::numeric_limits<int>::max();

/// As above with `take(uav, noun, utime)`, of UAVs 1 to `uavs`; nobody else is listened to.
template <class Message, class Take>
void HearNouns(Bus& bus, const UavChannel<Message>& channel, int uavs, Inbox<Message>& inbox,
               const Take& take) {
  for (const auto& [uav, message] : inbox.Take()) {
    if (uav < 1 || uav > uavs) continue;
    try {
      take(uav, Decode(message), message.utime);
    } catch (const BadMessage& error) {
      bus.Reject(channel.Of(uav), error.what());
    }
  }
}

}  // namespace citrine

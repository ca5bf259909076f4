#pragma once

#include <exception>
#include <string>

#include "modules/channels.h"
#include "modules/codec/bad_message.h"
#include "modules/runtime/log_event.h"

namespace citrine {

/// One event of a log, by who spoke: UAV<uav>_<noun>, or the whole channel where `uav` is 0.
struct RecordedMessage {
  const LogEvent& event;
  int uav = 0;
  std::string noun;

  explicit RecordedMessage(const LogEvent& said);

  /// Calls `hear` with the decoded message if it was said on this channel.
  /// @throws BadMessage if it is not of the channel's type
  template <class Message, class Hear>
  void On(const Channel<Message>& on, Hear hear) const {
    if (uav == 0 && event.channel == on.name) hear(As<Message>());
  }
  template <class Message, class Hear>
  void On(const UavChannel<Message>& on, Hear hear) const {
    if (uav > 0 && noun == on.noun) hear(As<Message>());
  }

 private:
  template <class Message>
  Message As() const {
    Message message{};
    const int size = static_cast<int>(event.bytes.size());
    try {
      if (message.decode(event.bytes.data(), 0, size) == size) return message;
    } catch (const std::exception& error) {
      throw BadMessage(event.channel + ": " + error.what());
    }
    throw BadMessage(event.channel + ": another type or cut short");
  }
};

}  // namespace citrine

#pragma once

#include <map>
#include <string>
#include <vector>

#include "modules/channels.h"
#include "modules/runtime/log_event.h"

namespace citrine {

/// Writes down messages as a bus would have carried them.
class Recorder {
 public:
  template <class Message>
  void Say(const Channel<Message>& channel, Utime utime, Message message) {
    Add(channel.name, utime, message);
  }
  template <class Message>
  void Say(const UavChannel<Message>& channel, int uav, Utime utime, Message message) {
    Add(channel.Of(uav), utime, message);
  }
  void SayBytes(const std::string& channel, Utime utime, std::vector<std::uint8_t> bytes) {
    events_.push_back({utime, channel, std::move(bytes)});
  }

  const std::vector<LogEvent>& events() const { return events_; }

 private:
  template <class Message>
  void Add(const std::string& channel, Utime utime, Message& message) {
    message.utime = utime;
    message.seq = ++said_[channel];
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(message.getEncodedSize()));
    message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
    SayBytes(channel, utime, std::move(bytes));
  }

  std::vector<LogEvent> events_;
  std::map<std::string, std::int64_t> said_;
};

}  // namespace citrine

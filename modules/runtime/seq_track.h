#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "core/time.h"

namespace citrine {

/// Several modules speak on a channel whose messages name their sender; on all others one does.
template <class Message>
inline constexpr bool kManySenders = requires(Message m) {
  m.sender;
}
|| requires(Message m) { m.module; };

/// Who of several senders said a message: the UAV, or module and UAV; empty on a channel with one sender.
template <class Message>
std::string SenderOf([[maybe_unused]] const Message& message) {
  if constexpr (requires { message.module; })
    return message.module + "/" + std::to_string(message.uav);
  else if constexpr (requires { message.sender; })
    return std::to_string(message.sender);
  else
    return {};
}

/// The newest message of one sender on one channel: tells news from repetitions, and what is missing between.
struct SeqTrack {
  struct Arrival {
    bool is_new = false;
    std::int64_t lost = 0;  ///< messages between this one and the newest before it
  };

  std::int64_t seq = 0;  ///< 0: nothing heard
  Utime utime = 0;

  /// A lower seq at a later time is a sender that began anew. Nothing is missing before the first message
  /// heard.
  Arrival Advance(Utime new_utime, std::int64_t new_seq) {
    const bool restarted = new_seq <= seq && new_utime > utime;
    if (new_seq <= seq && !restarted) return {};
    const std::int64_t lost = seq == 0 || restarted ? 0 : new_seq - seq - 1;
    seq = new_seq;
    utime = new_utime;
    return {true, lost};
  }
};

using SeqTracks = std::map<std::pair<std::string, std::string>, SeqTrack>;  ///< by channel and sender

}  // namespace citrine

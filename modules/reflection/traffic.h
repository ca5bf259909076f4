#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "modules/runtime/seq_track.h"

namespace citrine {

/// What has been said on one channel.
struct ChannelTraffic {
  std::string type;  ///< "?" for messages that are not ours
  std::int64_t messages = 0, bytes = 0;
  std::int64_t lost = 0;                               ///< gaps in seq, per sender
  std::int64_t bad = 0;                                ///< that do not decode as their type
  Utime first = 0, last = 0;                           ///< mission time
  double first_s = 0, last_s = 0;                      ///< when heard, by the clock of whoever listens
  std::deque<std::pair<double, std::int64_t>> recent;  ///< when, and bytes; of the last seconds
};

/// Counts what is said on a bus or stands in a log, channel by channel, whatever its type.
class Traffic {
 public:
  /// @param recent_s how long a message counts for the rates of now; 0: nothing is kept for them
  explicit Traffic(double recent_s = 0) : recent_s_(recent_s) {}

  struct Heard {
    std::int64_t lost = 0;  ///< messages missing before this one
    std::string bad;        ///< why it does not decode; empty if it does
  };
  /// @param at_s when, by the listener's clock
  Heard Hear(const std::string& channel, std::span<const std::uint8_t> message, double at_s);

  const std::map<std::string, ChannelTraffic>& channels() const { return channels_; }

  /// Messages and bytes a second over the last `recent_s`, or since the first message if that is less ago.
  struct Rate {
    double messages_hz = 0, bytes_per_s = 0;
  };
  Rate RateAt(double now_s, const ChannelTraffic& channel) const;

 private:
  double recent_s_;
  std::map<std::string, ChannelTraffic> channels_;
  SeqTracks tracks_;
};

}  // namespace citrine

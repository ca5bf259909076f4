#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/time.h"

namespace citrine {

/// One message of a log.
struct LogEvent {
  Utime time = 0;  ///< of the event: mission time in our logs, wall time of receipt in lcm-logger's
  std::string channel;
  std::vector<std::uint8_t> bytes;  ///< the message as it travels

  /// What every message of ours begins with, behind its fingerprint; 0 in one that is too short to be ours.
  Utime utime() const { return BigEndian(8); }
  std::int64_t seq() const { return BigEndian(16); }

  /// The order of a log that says the same whoever recorded it: by mission time, channel, seq, and bytes
  /// where several senders have counted alike.
  bool operator<(const LogEvent& other) const;
  bool operator==(const LogEvent& other) const { return channel == other.channel && bytes == other.bytes; }

 private:
  std::int64_t BigEndian(std::size_t at) const;
};

}  // namespace citrine

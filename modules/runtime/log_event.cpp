#include "modules/runtime/log_event.h"

namespace citrine {

std::int64_t LogEvent::BigEndian(std::size_t at) const {
  if (bytes.size() < at + 8) return 0;
  std::uint64_t value = 0;
  for (std::size_t i = at; i < at + 8; ++i) value = value << 8 | bytes[i];
  return static_cast<std::int64_t>(value);
}

bool LogEvent::operator<(const LogEvent& other) const {
  if (utime() != other.utime()) return utime() < other.utime();
  if (channel != other.channel) return channel < other.channel;
  if (seq() != other.seq()) return seq() < other.seq();
  return bytes < other.bytes;
}

}  // namespace citrine

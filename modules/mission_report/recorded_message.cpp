#include "modules/mission_report/recorded_message.h"

#include <charconv>

namespace citrine {
namespace {

constexpr int kMaxUavs = 15;

}  // namespace

RecordedMessage::RecordedMessage(const LogEvent& said) : event(said) {
  const std::string& channel = said.channel;
  if (channel.rfind("UAV", 0) != 0) return;
  int id = 0;
  const auto [end, error] = std::from_chars(channel.data() + 3, channel.data() + channel.size(), id);
  if (error != std::errc() || id < 1 || id > kMaxUavs || *end != '_') return;
  uav = id;
  noun = end + 1;
}

}  // namespace citrine

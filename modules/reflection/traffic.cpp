#include "modules/reflection/traffic.h"

#include <algorithm>

#include "modules/codec/bad_message.h"
#include "modules/reflection/message_fields.h"
#include "modules/reflection/message_types.h"

namespace citrine {
namespace {

constexpr double kLeast_s = 0.5;  // over which a rate means something

}  // namespace

Traffic::Heard Traffic::Hear(const std::string& channel, std::span<const std::uint8_t> message, double at_s) {
  ChannelTraffic& said = channels_[channel];
  const MessageType* type = TypeOf(message);
  if (said.messages == 0) said.first_s = at_s;
  said.last_s = at_s;
  ++said.messages;
  said.bytes += static_cast<std::int64_t>(message.size());
  said.type = type ? type->name : "?";
  if (recent_s_ > 0) said.recent.emplace_back(at_s, message.size());
  while (!said.recent.empty() && said.recent.front().first < at_s - recent_s_) said.recent.pop_front();
  Heard heard;
  try {
    Require(type, "no type of ours");
    const std::vector<FieldValues> fields = ReadFields(*type, message);
    const Utime utime = fields[0].integer();
    if (said.messages - said.bad == 1) said.first = utime;
    said.last = std::max(said.last, utime);
    heard.lost = tracks_[{channel, SenderOf(fields)}].Advance(utime, fields[1].integer()).lost;
    said.lost += heard.lost;
  } catch (const BadMessage& error) {
    ++said.bad;
    heard.bad = error.what();
  }
  return heard;
}

Traffic::Rate Traffic::RateAt(double now_s, const ChannelTraffic& channel) const {
  Rate rate;
  for (const auto& [at_s, bytes] : channel.recent) {
    if (at_s < now_s - recent_s_) continue;
    ++rate.messages_hz;
    rate.bytes_per_s += static_cast<double>(bytes);
  }
  const double over_s = std::clamp(now_s - channel.first_s, kLeast_s, std::max(recent_s_, kLeast_s));
  rate.messages_hz /= over_s;
  rate.bytes_per_s /= over_s;
  return rate;
}

}  // namespace citrine

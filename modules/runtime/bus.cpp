#include "modules/runtime/bus.h"

#include <regex>
#include <stdexcept>

namespace citrine {

Bus::Bus(std::shared_ptr<Transport> transport) : transport_(std::move(transport)) {}

void Bus::SayBytes(const std::string& channel, const std::vector<std::uint8_t>& bytes) {
  if (bytes.size() > kMaxMessageBytes)
    throw std::length_error(channel + ": a message of " + std::to_string(bytes.size()) + " bytes; at most " +
                            std::to_string(kMaxMessageBytes) + " travel safely, bulk goes in chunks");
  transport_->Send(channel, bytes);
  counts_.bytes_said += static_cast<std::int64_t>(bytes.size());
}

void Bus::Subscribe(const std::string& channel_regex, int queue, bool many_senders, Store store) {
  heard_regexes_.emplace_back(channel_regex, many_senders);
  many_senders_by_channel_.clear();
  subscriptions_.push_back(transport_->Subscribe(channel_regex, queue, std::move(store)));
}

void Bus::HearBytes(const std::string& channel_regex, BytesHearer hearer) {
  subscriptions_.push_back(transport_->Subscribe(channel_regex, 0, std::move(hearer)));
}

void Bus::Reject(const std::string& channel, const std::string& reason) {
  ++counts_.bad;
  counts_.last_bad = channel + ": " + reason;
}

void Bus::BeginStep(const Step& step, bool lockstep) {
  step_ = step;
  for (const auto& release : release_) release(step, lockstep);
}

int Bus::UavOf(const std::string& channel) {
  return channel.starts_with("UAV") ? std::atoi(channel.c_str() + 3) : 0;
}

std::optional<bool> Bus::ManySendersOn(const std::string& channel) const {
  const auto [known, is_new] = many_senders_by_channel_.try_emplace(channel);
  if (is_new)
    for (const auto& [regex, many_senders] : heard_regexes_)
      if (std::regex_match(channel, std::regex(regex))) known->second = many_senders;
  return known->second;
}

std::optional<std::pair<std::string, std::string>> Bus::TrackOf(const std::string& channel, int uav) const {
  const auto many_senders = ManySendersOn(channel);
  if (!many_senders) return std::nullopt;
  return std::pair(channel, *many_senders ? std::to_string(uav) : std::string());
}

bool Bus::Misses(const std::string& channel, int uav, std::int64_t seq) const {
  const auto key = TrackOf(channel, uav);
  if (!key) return false;
  const auto track = heard_.find(*key);
  return track == heard_.end() || track->second.seq < seq;
}

void Bus::GiveUp(const std::string& channel, int uav, std::int64_t seq) {
  if (!Misses(channel, uav, seq)) return;
  SeqTrack& track = heard_[*TrackOf(channel, uav)];
  counts_.lost += track.seq == 0 ? 1 : seq - track.seq;
  track = {seq, step_.now};
}

}  // namespace citrine

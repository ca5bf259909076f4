#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "core/time.h"
#include "modules/runtime/seq_track.h"
#include "modules/runtime/step.h"
#include "modules/runtime/transport.h"

namespace citrine {

/// A channel and the type of its messages.
template <class Message>
struct Channel {
  const char* name;
};

/// One channel for each UAV, named UAV<id>_<noun>; ids 1..N.
template <class Message>
struct UavChannel {
  const char* noun;
  std::string Of(int uav) const { return "UAV" + std::to_string(uav) + "_" + noun; }
  std::string OfAll() const { return std::string("UAV[0-9]+_") + noun; }
};

/// What a bus has counted since it was opened; said in MODULE_HEALTH.
struct BusCounts {
  std::int64_t lost = 0;  ///< gaps in seq
  std::int64_t bad = 0;   ///< messages that did not decode or meant nothing
  std::string last_bad;   ///< channel and reason of the newest bad one
  std::int64_t bytes_said = 0;
};

/// Messages of one subscription that wait for the next Tick.
template <class Message>
class Inbox {
 public:
  struct Entry {
    int uav = 0;  ///< who spoke; 0 on a channel that is not a UAV's
    Message message;
  };

  /// What was said before the present step, in order of channel and seq; each entry once.
  std::vector<Entry> Take() { return std::exchange(ready_, {}); }

 private:
  friend class Bus;
  std::vector<Entry> ready_;
};

/// The message bus as one module sees it: typed, counted, single-threaded. Handlers only store (design,
/// section 4).
///
/// Every message begins `utime`, `seq`: Publish() sets both, to the mission time of the present step and to a
/// count per bus and channel. So each module has a bus of its own; those of one process share a transport. A
/// message that does not decode is dropped and counted; Decode() errors are reported by `Reject`.
class Bus {
 public:
  /// @param url LCM provider: "memq://" (one process), "udpm://...", "file://..."
  /// @throws std::runtime_error if LCM cannot open it
  explicit Bus(const std::string& url) : Bus(std::make_shared<Transport>(url)) {}
  explicit Bus(std::shared_ptr<Transport> transport);
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  template <class Message>
  void Publish(const Channel<Message>& channel, Message message) {
    Say(channel.name, message);
  }
  template <class Message>
  void Publish(const UavChannel<Message>& channel, int uav, Message message) {
    Say(channel.Of(uav), message);
  }

  /// Keeps what is said on a channel until the inbox is taken. @param queue LCM's queue length, 0 unlimited
  template <class Message>
  std::shared_ptr<Inbox<Message>> Hear(const Channel<Message>& channel, int queue = 0) {
    return Listen<Message>(channel.name, queue);
  }
  /// As above: every UAV's, or one UAV's.
  template <class Message>
  std::shared_ptr<Inbox<Message>> HearAll(const UavChannel<Message>& channel, int queue = 0) {
    return Listen<Message>(channel.OfAll(), queue);
  }
  template <class Message>
  std::shared_ptr<Inbox<Message>> Hear(const UavChannel<Message>& channel, int uav, int queue = 0) {
    return Listen<Message>(channel.Of(uav), queue);
  }

  /// Counts a message that decoded but means nothing; for a module that caught BadMessage.
  void Reject(const std::string& channel, const std::string& reason);

  /// Runs LCM's handlers for what is pending, waiting at most `timeout_ms` for the first. @return how many
  int Handle(int timeout_ms) { return transport_->Handle(timeout_ms); }

  /// Begins a step: from now on messages are stamped `step.now`, and inboxes offer what was said before it
  /// (in lockstep) or what has arrived (otherwise).
  void BeginStep(const Step& step, bool lockstep);

  /// Calls `hearer(channel, bytes, size)` as soon as a message is handled, own ones too; for recorders and
  /// the lockstep.
  using BytesHearer = Transport::Hearer;
  void HearBytes(const std::string& channel_regex, BytesHearer hearer);

  /// Says bytes as they are, utime and seq included: to repeat or to replay.
  /// @throws std::length_error for more than kMaxMessageBytes, std::runtime_error if LCM cannot send them
  void SayBytes(const std::string& channel, const std::vector<std::uint8_t>& bytes);
  static constexpr std::size_t kMaxMessageBytes = 60'000;

  template <class Message>
  static std::vector<std::uint8_t> ToBytes(const Message& message) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(message.getEncodedSize()));
    message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
    return bytes;
  }

  /// Last seq said on each channel so far.
  const std::map<std::string, std::int64_t>& last_said() const { return said_; }
  /// Newest message heard of each channel that is subscribed to, by channel and sender (SenderOf).
  const SeqTracks& last_heard() const { return heard_; }

  /// Whether an inbox waits for message `seq` of a channel, said by a module of `uav`, and it has not come
  /// yet.
  bool Misses(const std::string& channel, int uav, std::int64_t seq) const;
  /// Counts what Misses() as lost and waits no more.
  void GiveUp(const std::string& channel, int uav, std::int64_t seq);

  const BusCounts& counts() const { return counts_; }
  Utime now() const { return step_.now; }

 private:
  using Store = Transport::Hearer;

  template <class Message>
  void Say(const std::string& channel, Message& message) {
    message.utime = step_.now;
    message.seq = ++said_[channel];
    SayBytes(channel, ToBytes(message));
  }

  template <class Message>
  std::shared_ptr<Inbox<Message>> Listen(const std::string& channel_regex, int queue);

  void Subscribe(const std::string& channel_regex, int queue, bool many_senders, Store store);
  static int UavOf(const std::string& channel);
  /// How the newest message of one sender on a channel is filed; nullopt if no inbox hears it.
  std::optional<std::pair<std::string, std::string>> TrackOf(const std::string& channel, int uav) const;
  /// Whether several senders speak on a channel; nullopt if no inbox hears it.
  std::optional<bool> ManySendersOn(const std::string& channel) const;

  std::shared_ptr<Transport> transport_;
  Step step_;
  BusCounts counts_;
  std::map<std::string, std::int64_t> said_;
  SeqTracks heard_;
  std::vector<std::pair<std::string, bool>> heard_regexes_;  ///< and whether several senders speak there
  mutable std::map<std::string, std::optional<bool>> many_senders_by_channel_;
  std::vector<std::unique_ptr<Transport::Subscription>> subscriptions_;
  std::vector<std::function<void(const Step&, bool lockstep)>> release_;  ///< one an inbox
};

template <class Message>
std::shared_ptr<Inbox<Message>> Bus::Listen(const std::string& channel_regex, int queue) {
  struct Arrival {
    std::string channel, sender;
    typename Inbox<Message>::Entry entry;
    auto order() const { return std::tie(channel, entry.message.utime, entry.message.seq, sender); }
  };
  auto inbox = std::make_shared<Inbox<Message>>();
  auto arrivals = std::make_shared<std::vector<Arrival>>();
  const auto tracks = std::make_shared<SeqTracks>();
  Subscribe(channel_regex, queue, kManySenders<Message>,
            [=, this](const std::string& channel, const void* data, int size) {
              Message message{};
              try {
                if (message.decode(data, 0, size) != size)
                  return Reject(channel, "another type or cut short");
              } catch (const std::exception& error) {
                return Reject(channel, error.what());
              }
              const std::pair key(channel, SenderOf(message));
              counts_.lost += heard_[key].Advance(message.utime, message.seq).lost;
              if ((*tracks)[key].Advance(message.utime, message.seq).is_new)
                arrivals->push_back({channel, key.second, {UavOf(channel), std::move(message)}});
            });
  release_.push_back([inbox, arrivals](const Step& step, bool lockstep) {
    const auto due = [&](const Arrival& a) { return !lockstep || a.entry.message.utime < step.now; };
    const auto first_later = std::stable_partition(arrivals->begin(), arrivals->end(), due);
    std::sort(arrivals->begin(), first_later,
              [](const Arrival& a, const Arrival& b) { return a.order() < b.order(); });
    for (auto it = arrivals->begin(); it != first_later; ++it) inbox->ready_.push_back(std::move(it->entry));
    arrivals->erase(arrivals->begin(), first_later);
  });
  return inbox;
}

}  // namespace citrine

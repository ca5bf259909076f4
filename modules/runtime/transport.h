#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <lcm/lcm.h>

namespace citrine {

/// LCM_DEFAULT_URL, else LCM's own group and port with ttl=0 and as large a receive buffer as the kernel
/// grants, up to 2 MiB.
std::string DefaultBusUrl();

/// Whether a channel is one on which a bus tests itself, by LCM's hand or CheckHearsItself().
bool IsOfTheBus(const std::string& channel);

/// Bytes on channels: one LCM connection, which the buses of one process may share. Single-threaded.
class Transport {
 public:
  using Hearer = std::function<void(const std::string& channel, const void* bytes, int size)>;

  /// @param url LCM provider: "memq://" (one process), "udpm://...", "file://..."
  /// @throws std::runtime_error if LCM cannot open it
  explicit Transport(const std::string& url);
  ~Transport();
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;

  /// @throws std::runtime_error if LCM cannot send it
  void Send(const std::string& channel, const std::vector<std::uint8_t>& bytes);

  /// Ends the subscription when destroyed; must not outlive the transport.
  class Subscription;
  /// @param channel_regex anchored at both ends  @param queue LCM's queue length, 0 unlimited
  std::unique_ptr<Subscription> Subscribe(const std::string& channel_regex, int queue, Hearer hearer);

  /// Runs the hearers for what is pending, waiting at most `timeout_ms` for the first. @return how many
  /// messages
  /// @throws what a hearer threw, once LCM's own frames have returned
  int Handle(int timeout_ms);

  /// @throws std::runtime_error, with what to do about it, if this process does not hear itself within 2 s
  void CheckHearsItself();

  const std::string& url() const { return url_; }

 private:
  std::string url_;
  lcm_t* lcm_;
  std::exception_ptr error_;
};

class Transport::Subscription {
 public:
  Subscription(Transport& transport, Hearer hearer) : transport_(transport), hearer_(std::move(hearer)) {}
  ~Subscription();
  Subscription(const Subscription&) = delete;
  Subscription& operator=(const Subscription&) = delete;

 private:
  friend class Transport;
  static void OnMessage(const lcm_recv_buf_t* buffer, const char* channel, void* subscription);

  Transport& transport_;
  Hearer hearer_;
  lcm_subscription_t* handle_ = nullptr;
};

}  // namespace citrine

#include "modules/runtime/transport.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "modules/runtime/stopwatch.h"

namespace citrine {
namespace {

constexpr long kReceiveBuffer_bytes = 2 << 20;  // what 40 messages of 250 kB at 20 Hz need to arrive whole
constexpr double kDeafAfter_ms = 2000;
constexpr const char* kProbeChannel = "BUS_PROBE";

/// LCM tells a missing route in a dozen lines on stderr; one of ours says the same.
lcm_t* CreateQuietly(const std::string& url) {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC),
            saved = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 0);
  std::fflush(stderr);
  dup2(nowhere, STDERR_FILENO);
  lcm_t* const lcm = lcm_create(url.c_str());
  std::fflush(stderr);
  dup2(saved, STDERR_FILENO);
  close(nowhere);
  close(saved);
  return lcm;
}

}  // namespace

bool IsOfTheBus(const std::string& channel) { return channel == "LCM_SELF_TEST" || channel == kProbeChannel; }

std::string DefaultBusUrl() {
  if (const char* url = std::getenv("LCM_DEFAULT_URL"); url && *url) return url;
  long granted = kReceiveBuffer_bytes;
  std::ifstream("/proc/sys/net/core/rmem_max") >> granted;
  return "udpm://239.255.76.67:7667?ttl=0&recv_buf_size=" +
         std::to_string(std::min(granted, kReceiveBuffer_bytes));
}

Transport::Transport(const std::string& url) : url_(url), lcm_(CreateQuietly(url)) {
  if (lcm_) return;
  if (!url.starts_with("udpm")) throw std::runtime_error("cannot open the bus '" + url + "'");
  throw std::runtime_error("cannot open the bus '" + url +
                           "'; without a multicast route: sudo ip link set lo multicast on && "
                           "sudo ip route add 224.0.0.0/4 dev lo");
}

Transport::~Transport() { lcm_destroy(lcm_); }

void Transport::Send(const std::string& channel, const std::vector<std::uint8_t>& bytes) {
  if (lcm_publish(lcm_, channel.c_str(), bytes.data(), static_cast<unsigned>(bytes.size())) != 0)
    throw std::runtime_error("cannot say " + channel + " on the bus '" + url_ + "'" +
                             (url_.starts_with("tcpq")
                                  ? "; start its broker first: java -cp lcm.jar lcm.lcm.TCPService PORT"
                                  : ""));
}

std::unique_ptr<Transport::Subscription> Transport::Subscribe(const std::string& channel_regex, int queue,
                                                              Hearer hearer) {
  auto subscription = std::make_unique<Subscription>(*this, std::move(hearer));
  subscription->handle_ =
      lcm_subscribe(lcm_, channel_regex.c_str(), &Subscription::OnMessage, subscription.get());
  if (!subscription->handle_)
    throw std::runtime_error("cannot hear " + channel_regex + " on the bus '" + url_ + "'");
  lcm_subscription_set_queue_capacity(subscription->handle_, queue);
  return subscription;
}

Transport::Subscription::~Subscription() {
  if (handle_) lcm_unsubscribe(transport_.lcm_, handle_);
}

void Transport::Subscription::OnMessage(const lcm_recv_buf_t* buffer, const char* channel,
                                        void* subscription) {
  auto& self = *static_cast<Subscription*>(subscription);
  try {
    self.hearer_(channel, buffer->data, static_cast<int>(buffer->data_size));
  } catch (...) {  // an exception that crosses LCM's frames makes its next handle() abort
    if (!self.transport_.error_) self.transport_.error_ = std::current_exception();
  }
}

int Transport::Handle(int timeout_ms) {
  int handled = 0;
  while (lcm_handle_timeout(lcm_, handled > 0 ? 0 : timeout_ms) > 0) {
    ++handled;
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
  }
  return handled;
}

void Transport::CheckHearsItself() {
  const std::string token =
      std::to_string(getpid()) + "@" + std::to_string(reinterpret_cast<std::uintptr_t>(this));
  bool heard = false;
  const auto probe = Subscribe(kProbeChannel, 0, [&](const std::string&, const void* bytes, int size) {
    heard |= token == std::string(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
  });
  for (const Stopwatch since; !heard;) {
    Send(kProbeChannel, {token.begin(), token.end()});
    Handle(100);
    if (!heard && since.ms() > kDeafAfter_ms)
      throw std::runtime_error(
          "the bus '" + url_ +
          "' is deaf: this process does not hear itself. Either another program holds "
          "its UDP port (ss -ulpn; choose another port with LCM_DEFAULT_URL), or multicast has no route "
          "(sudo ip link set lo multicast on && sudo ip route add 224.0.0.0/4 dev lo)");
  }
}

}  // namespace citrine

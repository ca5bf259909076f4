#include "modules/launch/bus_checks.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <exception>
#include <fstream>
#include <stdexcept>

#include "modules/channels.h"
#include "modules/codec/clock.h"
#include "modules/launch/port_holder.h"
#include "modules/runtime/stopwatch.h"

namespace citrine {
namespace {

constexpr long kReceiveBufferWanted_bytes = 2 << 20;

/// What the child tells: one letter for each thing that works, then the other mission's name.
constexpr char kOpens = 'o', kHears = 'h';

void Tell(int pipe, const std::string& text) {
  [[maybe_unused]] const ssize_t written = write(pipe, text.data(), text.size());
}

std::string ListenForClock(const std::shared_ptr<Transport>& transport, double listen_s) {
  Bus bus(transport);
  const auto clock = bus.Hear(channels::kClock, 1);
  for (const Stopwatch since; since.ms() < listen_s * 1e3;) {
    bus.Handle(20);
    bus.BeginStep({}, false);
    for (const auto& entry : clock->Take())
      if (entry.message.state == citrine_lcm::clock_t::RUNNING) return entry.message.mission_id;
  }
  return {};
}

void Check(const std::string& url, double listen_s, int pipe) {
  try {
    const auto transport = std::make_shared<Transport>(url);
    Tell(pipe, {kOpens});
    transport->CheckHearsItself();
    Tell(pipe, {kHears});
    Tell(pipe, ListenForClock(transport, listen_s));
  } catch (const std::exception&) {  // what has not been told does not work
  }
}

std::string ReadAll(int pipe) {
  std::string text;
  std::array<char, 256> bytes;
  for (ssize_t n = 0; (n = read(pipe, bytes.data(), bytes.size())) > 0;)
    text.append(bytes.data(), static_cast<std::size_t>(n));
  return text;
}

}  // namespace

std::string DeafBus(const std::string& url) {
  const std::string holder = HolderOfPort(url);
  return "the bus " + url + " is deaf: UDP port " + std::to_string(PortOf(url)) + " is held by " +
         (holder.empty() ? "another program (sudo ss -ulpn names it)" : holder);
}

std::string WhyUnheard(const BusCheck& check, const std::string& url) {
  if (!check.opens) return std::string("no multicast route.\n  mend: ") + kRouteMulticast;
  if (!check.hears_itself) return DeafBus(url) + ".\n  mend: stop it, or " + kAnotherPort;
  return {};
}

void RequireHeard(const std::string& url) {
  if (!url.starts_with("udpm")) return;
  if (const std::string why = WhyUnheard(CheckBus(url, 0), url); !why.empty()) throw std::runtime_error(why);
}

std::optional<long> ReceiveBufferLimit() {
  long limit = 0;
  return std::ifstream("/proc/sys/net/core/rmem_max") >> limit ? std::optional(limit) : std::nullopt;
}

std::string SmallReceiveBuffer(std::optional<long> limit) {
  if (!limit || *limit >= kReceiveBufferWanted_bytes) return {};
  return "receive buffer limit is " + std::to_string(*limit) + " bytes: bursts on the bus may be lost";
}

BusCheck CheckBus(const std::string& url, double listen_s) {
  int pipe[2];
  if (pipe2(pipe, O_CLOEXEC) != 0) return {};
  const pid_t child = fork();
  if (child == 0) {
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    Check(url, listen_s, pipe[1]);
    _exit(0);
  }
  close(pipe[1]);
  const std::string told = ReadAll(pipe[0]);
  close(pipe[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  BusCheck check;
  check.opens = told.starts_with(kOpens);
  check.hears_itself = told.size() > 1 && told[1] == kHears;
  if (told.size() > 2) check.other_mission = told.substr(2);
  return check;
}

}  // namespace citrine

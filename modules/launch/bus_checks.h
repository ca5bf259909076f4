#pragma once

#include <optional>
#include <string>

namespace citrine {

/// What can be wrong with a bus before anybody speaks on it.
struct BusCheck {
  bool opens = true;          ///< false: no multicast route, as a rule
  bool hears_itself = true;   ///< false: the port is held by another program
  std::string other_mission;  ///< whose CLOCK is heard; empty: none
};

/// Listens for `listen_s`, in a child process that leaves no thread, socket or warning of LCM's behind.
BusCheck CheckBus(const std::string& url, double listen_s);

/// What to say of a bus that does not hear itself: who holds its port, if that can be seen.
std::string DeafBus(const std::string& url);

/// What keeps one from hearing a bus, and the command that mends it; empty if nothing does.
std::string WhyUnheard(const BusCheck& check, const std::string& url);

/// For a tool that listens: asks a UDP bus before it is opened; others tell it themselves when they are.
/// @throws std::runtime_error(WhyUnheard)
void RequireHeard(const std::string& url);

/// [byte] What the kernel grants a socket at most; nothing where it does not say.
std::optional<long> ReceiveBufferLimit();

/// What to say of a limit that is too small for this system's bursts; empty if it is not.
std::string SmallReceiveBuffer(std::optional<long> limit);

/// The commands that mend it, for messages to the user.
inline constexpr const char* kRouteMulticast =
    "sudo ip link set lo multicast on && sudo ip route add 224.0.0.0/4 dev lo";
inline constexpr const char* kLargerReceiveBuffer =
    "sudo sysctl -w net.core.rmem_max=4194304 net.core.rmem_default=4194304";
inline constexpr const char* kAnotherPort = "export LCM_DEFAULT_URL='udpm://239.255.76.67:7668?ttl=0'";

}  // namespace citrine

#include "modules/launch/network_choice.h"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "modules/launch/bus_checks.h"
#include "modules/launch/network_isolation.h"
#include "modules/runtime/transport.h"

namespace citrine {
namespace {

constexpr double kListen_s = 0.5;  // a CLOCK at pace 1 is said 25 times meanwhile

std::optional<std::string> PrivateBus() {
  unsetenv("LCM_DEFAULT_URL");  // whatever it names is not in there
  const std::string url = DefaultBusUrl();
  const std::optional<std::string> refusal = IsolateNetwork();
  if (!refusal) return url;
  std::fprintf(stderr, "citrine: a private network is refused (%s); flying in process, in lockstep\n",
               refusal->c_str());
  return std::nullopt;
}

}  // namespace

std::optional<std::string> ChooseBus(bool isolate) {
  if (const std::string small = SmallReceiveBuffer(ReceiveBufferLimit()); !small.empty())
    std::fprintf(stderr, "citrine: %s\n  mend: %s\n", small.c_str(), kLargerReceiveBuffer);
  if (isolate) return PrivateBus();
  const std::string url = DefaultBusUrl();
  const BusCheck bus = CheckBus(url, kListen_s);
  if (!bus.opens) {
    std::fprintf(stderr,
                 "citrine: no multicast route, so other terminals cannot hear this mission; flying isolated\n"
                 "  mend: %s\n",
                 kRouteMulticast);
    return PrivateBus();
  }
  if (const std::string why = WhyUnheard(bus, url); !why.empty())
    throw std::runtime_error(why + "\n  or fly on a private network: --isolate");
  if (!bus.other_mission.empty())
    throw std::runtime_error("another mission, " + bus.other_mission + ", is on the bus " + url +
                             ".\n  mend: wait for its end, or " + kAnotherPort +
                             "\n  or fly on a private network: --isolate");
  return url;
}

}  // namespace citrine

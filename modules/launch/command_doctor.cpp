#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "modules/launch/bus_checks.h"
#include "modules/launch/commands.h"
#include "modules/launch/network_isolation.h"
#include "modules/launch/project.h"
#include "modules/runtime/transport.h"

namespace citrine {
namespace {

constexpr double kListen_s = 1.0;
constexpr long kReceiveBufferWanted_bytes = 2 << 20;

/// One line a finding; `mend` is the one command that mends it.
class Findings {
 public:
  void Ok(const std::string& what) { Say("ok", what); }
  void Warn(const std::string& what, const std::string& mend) { Say("warn", what, mend); }
  void Fail(const std::string& what, const std::string& mend) {
    Say("FAIL", what, mend);
    failed_ = true;
  }
  bool failed() const { return failed_; }

 private:
  static void Say(const char* verdict, const std::string& what, const std::string& mend = "") {
    std::printf("%-5s %s\n", verdict, what.c_str());
    if (!mend.empty()) std::printf("      mend: %s\n", mend.c_str());
  }
  bool failed_ = false;
};

void LookAtPackages(Findings& findings) {
  const std::string missing = MissingPackages();
  if (missing.empty())
    findings.Ok("every package of packages.txt is installed");
  else
    findings.Fail("packages are missing: " + missing,
                  "sudo apt-get install --no-install-recommends " + missing);
}

void LookAtBus(Findings& findings) {
  const std::string url = DefaultBusUrl();
  const BusCheck bus = CheckBus(url, kListen_s);
  if (!bus.opens) return findings.Fail("no multicast route: modules cannot hear each other", kRouteMulticast);
  if (!bus.hears_itself)
    return findings.Fail("the bus " + url + " is deaf: another program holds its port (ss -ulpn names it)",
                         kAnotherPort);
  findings.Ok("the bus " + url + " hears itself");
  if (bus.other_mission.empty())
    findings.Ok("no other mission is on it");
  else
    findings.Warn("another mission, " + bus.other_mission + ", is on the bus", kAnotherPort);
}

void LookAtReceiveBuffer(Findings& findings) {
  long limit = 0;
  std::ifstream("/proc/sys/net/core/rmem_max") >> limit;
  if (limit >= kReceiveBufferWanted_bytes)
    findings.Ok("receive buffer limit " + std::to_string(limit) + " bytes");
  else
    findings.Warn(
        "receive buffer limit is " + std::to_string(limit) + " bytes: bursts on the bus may be lost",
        "sudo sysctl -w net.core.rmem_max=4194304 net.core.rmem_default=4194304");
}

/// Tried in a child: nobody comes back from a namespace.
void LookAtIsolation(Findings& findings) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) _exit(IsolateNetwork() ? 1 : 0);
  int status = 1;
  waitpid(child, &status, 0);
  if (status == 0)
    findings.Ok("--isolate works: private networks are allowed");
  else
    findings.Warn("--isolate is refused here: it will fly in process",
                  "sudo sysctl -w kernel.unprivileged_userns_clone=1");
}

void LookAtDisplay(Findings& findings) {
  if (std::getenv("DISPLAY") || std::getenv("WAYLAND_DISPLAY"))
    findings.Ok("a display for --view");
  else
    findings.Warn("no display for --view; --video needs none",
                  "ssh -X, or xvfb-run -a ./citrine run MISSION --view");
}

}  // namespace

int Doctor() {
  Findings findings;
  LookAtPackages(findings);
  LookAtBus(findings);
  LookAtReceiveBuffer(findings);
  LookAtIsolation(findings);
  LookAtDisplay(findings);
  return findings.failed() ? kSetUpProblem : kCompleted;
}

}  // namespace citrine

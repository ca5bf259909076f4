#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "modules/launch/bus_checks.h"
#include "modules/launch/commands.h"
#include "modules/launch/network_isolation.h"
#include "modules/launch/project.h"
#include "modules/launch/spy_parts.h"
#include "modules/runtime/transport.h"
#include "viz/display.h"

namespace citrine {
namespace {

constexpr double kListen_s = 1.0;

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
  if (!bus.hears_itself) return findings.Fail(DeafBus(url), kAnotherPort);
  findings.Ok("the bus " + url + " hears itself");
  if (bus.other_mission.empty())
    findings.Ok("no other mission is on it");
  else
    findings.Warn("another mission, " + bus.other_mission + ", is on the bus", kAnotherPort);
}

/// Java's tools never ask for a larger buffer, so that the default counts as well.
void LookAtReceiveBuffer(Findings& findings) {
  const std::optional<long> limit = ReceiveBufferLimit();
  if (const std::string small = SmallReceiveBuffer(limit); !small.empty())
    findings.Warn(small, kLargerReceiveBuffer);
  else
    findings.Ok("receive buffer limit " + (limit ? std::to_string(*limit) + " bytes" : "not known"));
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

void LookAtSpy(Findings& findings) {
  const SpyParts spy = FindSpyParts();
  if (!spy.missing.empty())
    findings.Warn("spy: " + spy.missing.substr(0, spy.missing.find('\n')),
                  "./citrine spy installs and builds it; ./citrine top needs neither");
  else if (!spy.stale.empty())
    findings.Warn("spy: " + spy.stale.substr(0, spy.stale.find('\n')), "./citrine spy builds it anew");
  else
    findings.Ok("lcm-spy: java, its charts, and " + spy.jar);
}

void LookAtDisk(Findings& findings) {
  constexpr std::uintmax_t kWanted_MB = 1000;
  std::error_code unknown;
  const std::uintmax_t free_MB = std::filesystem::space(".", unknown).available / 1'000'000;
  if (unknown || free_MB >= kWanted_MB)
    findings.Ok("disk: " + std::to_string(free_MB) + " MB free here, for logs");
  else
    findings.Warn("disk: " + std::to_string(free_MB) + " MB free here; a long mission's log takes more",
                  "./citrine run MISSION --out DIR on another disk, or --set launch.log_split_mb=50 --set "
                  "launch.log_keep=2");
}

void LookAtDisplay(Findings& findings) {
  if (const std::string why = viz::WhyNoDisplay(); !why.empty())
    findings.Warn("no window for --view: " + why + "; --video needs none", kDisplay);
  else
    findings.Ok("a display for --view");
}

}  // namespace

int Doctor() {
  Findings findings;
  LookAtPackages(findings);
  LookAtBus(findings);
  LookAtReceiveBuffer(findings);
  LookAtIsolation(findings);
  LookAtDisplay(findings);
  LookAtSpy(findings);
  LookAtDisk(findings);
  return findings.failed() ? kSetUpProblem : kCompleted;
}

}  // namespace citrine

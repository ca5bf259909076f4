#include "modules/launch/network_isolation.h"

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "modules/launch/bus_checks.h"
#include "modules/launch/port_holder.h"

namespace citrine {
namespace {

/// Runs `work` in a child, because nobody comes back from a namespace. @return its exit code
template <class Work>
int InChild(Work work) {
  const pid_t child = fork();
  if (child == 0) _exit(work());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

constexpr int kRefused = 77;

TEST(NetworkIsolation, APrivateBusHearsItselfAndNobodyElse) {
  const int exit_code = InChild([] {
    if (IsolateNetwork()) return kRefused;
    const BusCheck bus = CheckBus("udpm://239.255.76.67:7667?ttl=0", 0.1);
    return bus.opens && bus.hears_itself && bus.other_mission.empty() ? 0 : 1;
  });
  if (exit_code == kRefused) GTEST_SKIP() << "this host allows no private networks";
  EXPECT_EQ(exit_code, 0);
}

TEST(PortHolder, ReadsThePortOfAUrl) {
  EXPECT_EQ(PortOf("udpm://239.255.76.67:7668?ttl=0"), 7668);
  EXPECT_EQ(PortOf("udpm://239.255.76.67:7669"), 7669);
  EXPECT_EQ(PortOf("udpm://?ttl=0"), 7667);
}

TEST(BusChecks, ABusThatCannotBeOpenedIsNamed) {
  const BusCheck bus = CheckBus("nonsense://nowhere", 0.1);
  EXPECT_FALSE(bus.opens);
  EXPECT_FALSE(bus.hears_itself);
}

}  // namespace
}  // namespace citrine

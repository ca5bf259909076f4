#include "modules/runtime/in_process.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "core/config/config_file.h"
#include "modules/runtime/log_digest.h"
#include "tests/modules/runtime/toy_modules.h"

namespace citrine {
namespace {

std::uint64_t DigestOf(const std::vector<ModuleKind>& kinds) {
  LogDigest digest;
  RunInProcess(ParseMission("", {"launch.pace=0"}), kinds,
               {[&](const LogEvent& event) { digest.Add(event); }, {}, {}});
  return digest.value();
}

TEST(InProcess, EndsWhenTheOwnerOfTimeSaysSo) {
  std::map<std::string, int> count;
  const InProcessResult result =
      RunInProcess(ParseMission("", {"launch.pace=0"}), ToyKinds(),
                   {[&](const LogEvent& event) { ++count[event.channel]; }, {}, {}});
  EXPECT_EQ(result.stop_reason, "surface_complete");
  EXPECT_EQ(result.steps, kToySteps + 1) << "one more, for everybody's last tick";
  EXPECT_EQ(result.mission_time, kToySteps * 20'000);
  EXPECT_EQ(count["CLOCK"], kToySteps + 1);
  EXPECT_EQ(count["STEP_DONE"], 10 * (kToySteps + 1));
  EXPECT_EQ(count["UAV3_STATE"], kToySteps + 1);
}

TEST(InProcess, SaysTheSameInWhateverOrderItsModulesAreTicked) {
  auto kinds = ToyKinds();
  const std::uint64_t digest = DigestOf(kinds);
  EXPECT_EQ(DigestOf(kinds), digest);
  std::reverse(kinds.begin(), kinds.end());
  EXPECT_EQ(DigestOf(kinds), digest);
}

TEST(InProcess, HandsOnEventsInOrderOfTimeChannelAndSeq) {
  std::vector<LogEvent> events;
  RunInProcess(ParseMission("", {"launch.pace=0"}), ToyKinds(),
               {[&](const LogEvent& event) { events.push_back(event); }, {}, {}});
  EXPECT_TRUE(std::is_sorted(events.begin(), events.end()));
}

TEST(InProcess, EndsWhenItIsInterrupted) {
  int asked = 0;
  const auto result =
      RunInProcess(ParseMission("", {"launch.pace=0"}), ToyKinds(), {{}, [&] { return ++asked == 5; }, {}});
  EXPECT_EQ(result.stop_reason, "interrupted");
  EXPECT_EQ(result.steps, 6);
}

class Mortal : public Module {
 public:
  static constexpr const char* kName = "map_fusion";
  static constexpr const char* kSummary = "Dies.";
  static constexpr bool kHearsMap = false;
  static constexpr bool kPerUav = false;
  explicit Mortal(const ModuleContext&) {}
  void Tick(const Step& step) override {
    if (step.index == 3) throw std::runtime_error("out of paint");
  }
};

TEST(InProcess, EndsWhenAModuleDiesAndSaysWhich) {
  const auto result =
      RunInProcess(ParseMission("", {"launch.pace=0"}), {KindOf<ToyDynamics>(), KindOf<Mortal>()}, {});
  EXPECT_EQ(result.stop_reason, "module_died");
  EXPECT_EQ(result.error, "map_fusion: out of paint");
  EXPECT_EQ(result.steps, 5);
}

TEST(InProcess, RefusesAMissionWithoutAnOwnerOfTime) {
  EXPECT_THROW(RunInProcess(ParseMission("", {}), {KindOf<Mortal>()}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace citrine

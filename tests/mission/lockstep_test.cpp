#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "modules/launch/mission_resolver.h"
#include "modules/launch/module_list.h"
#include "modules/runtime/in_process.h"
#include "modules/runtime/log_digest.h"

namespace citrine {
namespace {

// Long enough for scans, blocks, decisions, paths and trajectories of both UAVs.
constexpr const char* kTimeLimit = "mission.time_limit_s=6";

struct Flown {
  std::uint64_t log_digest = 0;
  InProcessResult result;
  std::int64_t trajectories = 0;
};

Flown Fly(int seed, std::vector<ModuleKind> kinds) {
  const std::string out = testing::TempDir() + "citrine_mission_test";
  std::filesystem::create_directories(out);
  RunOptions options;
  options.mission = CITRINE_SOURCE_DIR "/missions/smoke.toml";
  options.overrides = {kTimeLimit, "launch.pace=0", "launch.in_process=true", "launch.out=" + out,
                       "mission.seed=" + std::to_string(seed)};
  LogDigest digest;
  Flown flown;
  InProcessCallbacks callbacks;
  callbacks.on_event = [&](const LogEvent& event) {
    digest.Add(event);
    flown.trajectories += event.channel.ends_with("_TRAJECTORY");
  };
  flown.result = RunInProcess(ResolveMission(options).config, kinds, callbacks);
  flown.log_digest = digest.value();
  std::filesystem::remove_all(out);
  return flown;
}

TEST(LockstepMission, SaysTheSameInWhateverOrderItsModulesAreTicked) {
  auto kinds = ModuleList();
  const Flown once = Fly(1, kinds);
  std::reverse(kinds.begin(), kinds.end());
  const Flown reversed = Fly(1, kinds);
  EXPECT_EQ(once.result.error, "");
  EXPECT_EQ(once.result.stop_reason, "time_limit");
  EXPECT_GT(once.trajectories, 1) << "the UAVs must have flown for this test to say anything";
  EXPECT_EQ(once.log_digest, reversed.log_digest);
}

TEST(LockstepMission, SaysTheSameForTheSameSeedAndSomethingElseForAnother) {
  const Flown once = Fly(1, ModuleList());
  EXPECT_EQ(once.log_digest, Fly(1, ModuleList()).log_digest);
  EXPECT_NE(once.log_digest, Fly(2, ModuleList()).log_digest);
}

}  // namespace
}  // namespace citrine

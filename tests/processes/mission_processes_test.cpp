#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/citrine_command.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class MissionProcesses : public ::testing::Test {
 protected:
  void SetUp() override {
    if (RunCommandLine("unshare -n true || unshare -rn true").exit_code != 0)
      GTEST_SKIP() << "this host allows no private networks";
    fs::remove_all(out_);
  }

  static nlohmann::json Metrics(const fs::path& out) {
    return nlohmann::json::parse(std::ifstream(out / "metrics.json"));
  }
  std::string Run(const std::string& options, const std::string& folder = "run") const {
    return std::string(CITRINE_BIN_DIR) + "/launch run smoke --out " + (out_ / folder).string() + " " +
           options;
  }
  /// Flies in the background and acts once the mission is under way. Expects `$launch` to be waited for.
  CommandResult RunAndThen(const std::string& options, const std::string& action) const {
    const std::string log = (out_ / "run/logs/map_fusion.log").string();
    return RunCommandLine(Run(options) + " & launch=$!; for i in $(seq 300); do [ -e " + log +
                          " ] && break; sleep 0.1; done; sleep 3; " + action + "; wait $launch");
  }

  const fs::path out_ = fs::path(::testing::TempDir()) / ("citrine_processes_" + std::to_string(getpid()));
};

TEST_F(MissionProcesses, SayInLockstepWhatOneProcessSays) {
  const std::string options = "--seed 3 --set mission.time_limit_s=20 ";
  const CommandResult apart = RunCommandLine(Run(options + "--isolate --pace max", "apart"));
  const CommandResult together = RunCommandLine(Run(options + "--in-process", "together"));
  ASSERT_TRUE(fs::exists(out_ / "apart/metrics.json")) << apart.output;
  ASSERT_TRUE(fs::exists(out_ / "together/metrics.json")) << together.output;
  EXPECT_EQ(Metrics(out_ / "apart")["log_digest"], Metrics(out_ / "together")["log_digest"]);
  EXPECT_EQ(Metrics(out_ / "apart")["map_digest"], Metrics(out_ / "together")["map_digest"]);
  EXPECT_EQ(Metrics(out_ / "apart")["messages_lost"], 0);
  EXPECT_EQ(apart.exit_code, together.exit_code);
}

TEST_F(MissionProcesses, WriteTheirResultsWhenInterrupted) {
  const CommandResult run = RunAndThen("--isolate --pace 1", "kill -INT $launch");
  EXPECT_EQ(run.exit_code, 130) << run.output;
  ASSERT_TRUE(fs::exists(out_ / "run/metrics.json")) << run.output;
  EXPECT_EQ(Metrics(out_ / "run")["stop_reason"], "interrupted");
  EXPECT_EQ(Metrics(out_ / "run")["completed"], false);
  for (const char* file : {"mission.lcmlog", "mission.toml", "mesh.ply", "report.html", "uav1.tum"})
    EXPECT_TRUE(fs::exists(out_ / "run" / file)) << file;
}

TEST_F(MissionProcesses, AreNamedWhenTheyDie) {
  const CommandResult run = RunAndThen("--isolate --pace 1", "kill -SEGV $(pgrep -P $launch map_fusion)");
  EXPECT_EQ(run.exit_code, 4) << run.output;
  EXPECT_THAT(run.output, HasSubstr("map_fusion died (SIGSEGV)"));
  ASSERT_TRUE(fs::exists(out_ / "run/metrics.json")) << run.output;
  EXPECT_EQ(Metrics(out_ / "run")["stop_reason"], "module_died");
}

TEST_F(MissionProcesses, LeaveNobodyBehindWhenTheLauncherIsKilled) {
  const CommandResult run =
      RunAndThen("--isolate --pace 1",
                 "children=$(pgrep -P $launch); kill -KILL $launch; sleep 1; "
                 "for pid in $children; do kill -0 $pid 2>/dev/null && echo left $pid; done");
  EXPECT_THAT(run.output, ::testing::Not(HasSubstr("left ")));
}

}  // namespace
}  // namespace citrine

#include <csignal>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/citrine_command.h"
#include "tests/support/scratch_folder.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

class MissionProcesses : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!PrivateNetworksAllowed()) GTEST_SKIP() << "this host allows no private networks";
  }

  static nlohmann::json Metrics(const fs::path& out) {
    return nlohmann::json::parse(std::ifstream(out / "metrics.json"));
  }
  std::string Run(const std::string& options, const std::string& folder = "run") const {
    return std::string(CITRINE_BIN_DIR) + "/launch run smoke --out " + (out_ / folder).string() + " " +
           options;
  }
  /// Flies in the background at pace 1 and acts once the mission is under way, with `$launch` and `$modules`,
  /// the processes' ids. Says "left ID" of every process that outlives the launcher.
  CommandResult RunAndThen(const std::string& options, const std::string& action) const {
    const std::string log = (out_ / "run/mission.toml").string();
    return RunCommandLine(Run("--pace 1 " + options) + " & launch=$!; for i in $(seq 300); do [ -e " + log +
                          " ] && break; sleep 0.1; done; sleep 5; modules=$(pgrep -P $launch); " + action +
                          "; wait $launch; code=$?; sleep 1; for pid in $modules; do "
                          "grep -qs '^State:.[^ZX]' /proc/$pid/status && echo left $pid; done; exit $code");
  }
  void ExpectResults() const {
    for (const char* file : {"metrics.json", "mission.lcmlog", "mission.toml", "mesh.ply", "map.bt",
                             "uav1.tum", "map.tsdf", "progress.csv", "topdown.png", "report.html"})
      EXPECT_TRUE(fs::exists(out_ / "run" / file)) << file;
  }

  const ScratchFolder scratch_;
  const fs::path out_ = scratch_.path();
};

TEST_F(MissionProcesses, SayInLockstepWhatOneProcessSays) {
  const std::string options = "--seed 3 ";
  const CommandResult apart = RunCommandLine(Run(options + "--isolate --pace max", "apart"));
  const CommandResult together = RunCommandLine(Run(options + "--in-process", "together"));
  ASSERT_TRUE(fs::exists(out_ / "apart/metrics.json")) << apart.output;
  ASSERT_TRUE(fs::exists(out_ / "together/metrics.json")) << together.output;
  EXPECT_EQ(Metrics(out_ / "apart")["log_digest"], Metrics(out_ / "together")["log_digest"]);
  EXPECT_EQ(Metrics(out_ / "apart")["map_digest"], Metrics(out_ / "together")["map_digest"]);
  EXPECT_EQ(Metrics(out_ / "apart")["messages_lost"], 0);
  EXPECT_EQ(apart.exit_code, 0) << apart.output;
  EXPECT_EQ(together.exit_code, 0) << together.output;
}

TEST_F(MissionProcesses, WriteTheirResultsWhenInterrupted) {
  const CommandResult run = RunAndThen("--isolate", "kill -INT $launch");
  EXPECT_EQ(run.exit_code, 130) << run.output;
  ExpectResults();
  ASSERT_TRUE(fs::exists(out_ / "run/metrics.json")) << run.output;
  EXPECT_EQ(Metrics(out_ / "run")["stop_reason"], "interrupted");
  EXPECT_EQ(Metrics(out_ / "run")["completed"], false);
  EXPECT_THAT(run.output, Not(HasSubstr("left ")));
}

TEST_F(MissionProcesses, WriteTheirResultsWhenTheOneProcessIsInterrupted) {
  // To a finer fidelity, or the mission would be over before.
  const CommandResult run = RunAndThen("--in-process --set quality.d_star_m=1", "kill -INT $launch");
  EXPECT_EQ(run.exit_code, 130) << run.output;
  ExpectResults();
  ASSERT_TRUE(fs::exists(out_ / "run/metrics.json")) << run.output;
  EXPECT_EQ(Metrics(out_ / "run")["stop_reason"], "interrupted");
}

TEST_F(MissionProcesses, AreNamedWhenTheyDie) {
  const CommandResult run =
      RunAndThen("--isolate", "kill -KILL $(pgrep -P $launch view_planner | head -n 1)");
  EXPECT_EQ(run.exit_code, 4) << run.output;
  EXPECT_THAT(run.output, ContainsRegex("view_planner[^ ]* died \\(SIGKILL\\)"));
  ExpectResults();
  ASSERT_TRUE(fs::exists(out_ / "run/metrics.json")) << run.output;
  EXPECT_EQ(Metrics(out_ / "run")["stop_reason"], "module_died");
  EXPECT_THAT(run.output, Not(HasSubstr("left ")));
}

TEST_F(MissionProcesses, ReportEvenWhenTheMapDied) {
  const CommandResult run = RunAndThen("--isolate", "kill -KILL $(pgrep -P $launch map_fusion)");
  EXPECT_EQ(run.exit_code, 4) << run.output;
  EXPECT_THAT(run.output, HasSubstr("map_fusion died (SIGKILL)"));
  ASSERT_TRUE(fs::exists(out_ / "run/metrics.json")) << run.output;
  EXPECT_EQ(Metrics(out_ / "run")["stop_reason"], "module_died");
}

TEST_F(MissionProcesses, AreWatchedFromOutsideTheirPrivateNetwork) {
  const std::string launch = std::string(CITRINE_BIN_DIR) + "/launch ",
                    run = " --run " + (out_ / "run").string();
  const CommandResult watch =
      RunAndThen("--isolate", launch + "top --seconds 2" + run + "; " + launch + "echo UAV2_STATE --count 1" +
                                  run + "; " + launch + "echo CLOCK" + run +
                                  " >/dev/null & sleep 1; kill -INT $launch; wait $!; "
                                  "echo echo ended with $?");
  EXPECT_THAT(watch.output, ContainsRegex("CLOCK +clock_t +[45][0-9]\\.[0-9] "));
  EXPECT_THAT(watch.output, HasSubstr("UAV2_STATE  uav_state_t  t 00:"));
  EXPECT_THAT(watch.output, HasSubstr("echo ended with 0"));
  EXPECT_THAT(RunCommandLine(launch + "top" + run).output,
              HasSubstr("no mission flies into this folder now"));
}

TEST_F(MissionProcesses, AreRecordedInPartsWhenTheyFlyForLong) {
  const CommandResult split =
      RunCommandLine(Run("--isolate --pace max --set launch.log_split_mb=2 --set mission.time_limit_s=20"));
  EXPECT_TRUE(fs::exists(out_ / "run/mission.lcmlog.001")) << split.output;
  EXPECT_FALSE(fs::exists(out_ / "run/mission.lcmlog"));
  const CommandResult whole = RunCommandLine(Run("--in-process --set mission.time_limit_s=20", "whole"));
  EXPECT_EQ(Metrics(out_ / "run")["log_digest"], Metrics(out_ / "whole")["log_digest"]) << whole.output;
}

TEST_F(MissionProcesses, SayWhoKeepsThemWaiting) {
  const CommandResult run = RunCommandLine(Run("--isolate --pace max --set quality.d_star_m=1") +
                                           " & launch=$!; sleep 6; planner=$(pgrep -P $launch view_planner | "
                                           "head -n 1); kill -STOP $planner; sleep 8; "
                                           "kill -CONT $planner; sleep 1; kill -INT $launch; wait $launch");
  EXPECT_EQ(run.exit_code, 130) << run.output;
  EXPECT_THAT(run.output, ContainsRegex("citrine: view_planner[12] has not answered for 5 s of wall time"));
}

TEST_F(MissionProcesses, SayWhoMissedMessages) {
  const CommandResult run = RunAndThen(
      "--isolate --set quality.d_star_m=1",
      "planner=$(pgrep -P $launch view_planner | head -n 1); kill -STOP $planner; sleep 4; kill -CONT "
      "$planner; sleep 3; kill -INT $launch");
  EXPECT_EQ(run.exit_code, 130) << run.output;
  EXPECT_THAT(
      run.output,
      ContainsRegex("citrine: bus: [0-9]+ messages were lost, [0-9]+ of them at view_planner[12]: a slow"));
}

TEST_F(MissionProcesses, GoOnFromTheMapOfAnEarlierMission) {
  const CommandResult first = RunCommandLine(Run("--in-process", "first"));
  ASSERT_EQ(first.exit_code, 0) << first.output;
  const CommandResult second =
      RunCommandLine(Run("--isolate --pace max --map " + (out_ / "first").string(), "second"));
  EXPECT_EQ(second.exit_code, 0) << second.output;
  const auto before = Metrics(out_ / "first"), after = Metrics(out_ / "second");
  EXPECT_LT(after["makespan_m"].get<double>(), 0.5 * before["makespan_m"].get<double>());
  EXPECT_GT(after["coverage_pct"].get<double>(), before["coverage_pct"].get<double>() - 1);
  const CommandResult other =
      RunCommandLine(Run("--set map.voxel_m=0.3 --map " + (out_ / "first").string(), "other"));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.output,
              HasSubstr("this mission asks for volume [-7, -7, 0] to [7, 7, 8] m, voxel 0.3 m"));
  EXPECT_EQ(RunCommandLine(Run("--map " + (out_ / "nowhere").string(), "other")).exit_code, 2);
}

TEST_F(MissionProcesses, LeaveNobodyBehindWhenTheLauncherIsKilled) {
  const CommandResult run = RunAndThen("--isolate", "kill -KILL $launch");
  EXPECT_EQ(run.exit_code, 128 + SIGKILL);
  EXPECT_THAT(run.output, Not(HasSubstr("left ")));
}

}  // namespace
}  // namespace citrine

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/modules/launch/sweep/sweep_file.h"
#include "tests/support/citrine_command.h"

namespace citrine {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(CommandSweep, FliesWhatIsOpenOnceAndComparesWhatItFlew) {
  const SweepFile file;
  const std::string out = file.folder() + "/out", sweep = "sweep " + file.Write() + " --seeds 3 --out " + out;
  const std::string shorter = " --set mission.time_limit_s=4";
  const CommandResult first = RunCitrine(sweep + shorter);
  EXPECT_EQ(first.exit_code, 0) << first.output;
  EXPECT_THAT(first.output, HasSubstr("2 missions, 0 of them finished"));
  EXPECT_THAT(first.output, HasSubstr("citrine: 2/2 smoke "));
  EXPECT_THAT(first.output, HasSubstr("| Method | Completed |"));
  EXPECT_TRUE(std::filesystem::exists(out + "/smoke/ours/3/report.html"));
  EXPECT_FALSE(std::filesystem::exists(out + "/smoke/ours/3/mission.lcmlog"));

  const CommandResult second = RunCitrine(sweep + shorter);
  EXPECT_EQ(second.exit_code, 0);
  EXPECT_THAT(second.output, HasSubstr("2 missions, 2 of them finished"));
  EXPECT_THAT(second.output, Not(HasSubstr("citrine: 2/2 smoke ")));

  std::filesystem::remove(out + "/smoke/frontier/3/metrics.json");
  EXPECT_THAT(RunCitrine(sweep + shorter).output, HasSubstr("citrine: 2/2 smoke frontier seed 3"));

  const CommandResult compared = RunCitrine("compare " + out + "/smoke/ours " + out + "/smoke/frontier");
  EXPECT_EQ(compared.exit_code, 0);
  EXPECT_THAT(compared.output, HasSubstr("planner.strategy  'quality_adaptive'  'nearest_frontier'"));
  EXPECT_THAT(compared.output, HasSubstr("says nothing about significance"));
}

TEST(CommandSweep, AnInterruptLetsTheMissionUnderWayEndAndTheNextCallGoesOn) {
  const SweepFile file;
  const std::string out = file.folder() + "/out", first = out + "/smoke/ours/3/mission.toml";
  const std::string sweep =
      "sweep " + file.Write() + " --seeds 3 --jobs 1 --set mission.time_limit_s=4 --out " + out;
  const CommandResult interrupted =
      RunCommandLine(std::string(CITRINE_BIN_DIR) + "/launch " + sweep + " & while [ ! -e " + first +
                     " ]; do sleep 0.1; done; kill -INT $!; wait $!");
  EXPECT_EQ(interrupted.exit_code, 130) << interrupted.output;
  EXPECT_THAT(interrupted.output, HasSubstr("citrine: 1/2 smoke ours seed 3: time_limit"));
  EXPECT_THAT(interrupted.output, HasSubstr("1 of 2 missions are finished"));
  const CommandResult rest = RunCitrine(sweep);
  EXPECT_EQ(rest.exit_code, 0);
  EXPECT_THAT(rest.output, HasSubstr("2 missions, 1 of them finished"));
  EXPECT_THAT(rest.output, HasSubstr("citrine: 2/2 smoke frontier seed 3: time_limit"));
}

TEST(CommandSweep, ShowsTheCommandsThatItWouldRun) {
  const SweepFile file;
  const CommandResult list = RunCitrine("sweep " + file.Write() + " --list --out " + file.folder() + "/out");
  EXPECT_EQ(list.exit_code, 0);
  EXPECT_EQ(std::count(list.output.begin(), list.output.end(), '\n'), 4);
  EXPECT_THAT(list.output, HasSubstr("./citrine run smoke --in-process --seed 2 "));
  EXPECT_FALSE(std::filesystem::exists(file.folder() + "/out"));
}

TEST(CommandSweep, WrongUseExitsWithOneAndWhatCannotBeFlownWithTwo) {
  ExpectExitCode(1, {"sweep", "sweep smoke --jobs 0", "compare here"});
  ExpectExitCode(2, {"sweep nowhere", "sweep smoke --list --seeds x", "compare nowhere neither"});
}

}  // namespace
}  // namespace citrine

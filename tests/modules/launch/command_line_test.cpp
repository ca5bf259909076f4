#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/citrine_command.h"
#include "tests/support/scratch_folder.h"

namespace citrine {
namespace {

using ::testing::HasSubstr, ::testing::Not;

TEST(CommandLine, HelpIsNotAMistake) {
  const CommandResult help = RunCitrine("--help");
  EXPECT_EQ(help.exit_code, 0);
  for (const char* command :
       {"run", "doctor", "config", "world", "replay", "export", "report", "sweep", "compare"})
    EXPECT_THAT(help.output, HasSubstr(command));
}

TEST(CommandLine, WrongUseExitsWithOne) {
  ExpectExitCode(1, {"", "fly house", "run", "run house --pase 2", "run house --pace fast",
                     "run house --pace -1", "run house --uavs three", "run house --in-process --isolate"});
}

TEST(CommandLine, AMissionThatIsNotThereExitsWithTwoAndNamesTheNearest) {
  const CommandResult run = RunCitrine("run hose");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("did you mean house?"));
}

TEST(CommandLine, AConfigurationThatCannotBeUsedExitsWithTwoInOneLine) {
  const CommandResult run = RunCitrine("run house --set mission.uav_count=3");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("mission.uav_count: unknown key; did you mean mission.uavs?"));
  EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1);
  EXPECT_THAT(RunCitrine("run house --uavs 99").output,
              HasSubstr("mission.uavs: must be an integer in [1, 15], is 99"));
}

TEST(CommandLine, AWorldThatIsNotThereExitsWithTwo) {
  const CommandResult run = RunCitrine("run smoke --in-process --world nowhere.sdf");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.output, HasSubstr("mission.world: no file 'nowhere.sdf'"));
}

TEST(CommandLine, AGoalThatTheGroundCannotReachIsSaidBeforeAnybodyFlies) {
  const ScratchFolder scratch;
  const std::string run =
      "run smoke --in-process --set mission.time_limit_s=1 --out " + scratch.path().string() + " --set ";
  // 1.125 m over the ground, it comes into the field of view 1.125 / sin(34 degrees) = 2.01 m away.
  EXPECT_THAT(RunCitrine(run + "quality.d_star_m=2").output, HasSubstr("seen from 2.01 m at the nearest"));
  EXPECT_THAT(RunCitrine(run + "quality.d_star_m=2.1").output, Not(HasSubstr("quality.d_star_m")));
}

TEST(CommandLine, ConfigShowsEveryKey) {
  const CommandResult config = RunCitrine("config");
  EXPECT_EQ(config.exit_code, 0);
  EXPECT_THAT(config.output, HasSubstr("mission.time_limit_s"));
  EXPECT_THAT(config.output, HasSubstr("launch.on_death"));
}

}  // namespace
}  // namespace citrine

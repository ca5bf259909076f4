#include "modules/launch/sweep/sweep_jobs.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/config/config.h"
#include "tests/modules/launch/sweep/sweep_file.h"
#include "tests/support/citrine_command.h"

namespace citrine {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class SweepJobs : public ::testing::Test {
 protected:
  Sweep Plan(const std::string& changes = "", SweepOptions options = {}) {
    options.sweep = file_.Write(changes);
    options.out = file_.folder() + "/out";
    return PlanSweep(options);
  }
  std::string Refusal(const std::string& changes, const SweepOptions& options = {}) {
    try {
      Plan(changes, options);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "accepted";
  }

  SweepFile file_;
};

TEST_F(SweepJobs, AreEveryWorldVariantAndSeedWithTheLastOverrideTheUsers) {
  SweepOptions options;
  options.set = {"mission.time_limit_s=7"};
  const Sweep sweep = Plan("", options);
  ASSERT_EQ(sweep.jobs.size(), 4u);
  EXPECT_EQ(sweep.jobs[0].command,
            "run smoke --in-process --seed 1 --set mission.time_limit_s=20 --set mission.time_limit_s=7");
  EXPECT_EQ(
      sweep.jobs[1].command,
      "run smoke --in-process --seed 1 --set mission.time_limit_s=20 --set planner.strategy=nearest_frontier "
      "--set mission.time_limit_s=7");
  EXPECT_EQ(sweep.jobs[1].folder, file_.folder() + "/out/smoke/frontier/1");
  EXPECT_EQ(sweep.jobs[2].seed, 2);
}

TEST_F(SweepJobs, SeedsAndCellsCanBeChosen) {
  SweepOptions options;
  options.seeds = "5-7";
  options.only = "smoke/front";
  const Sweep sweep = Plan("", options);
  ASSERT_EQ(sweep.jobs.size(), 3u);
  for (const SweepJob& job : sweep.jobs) EXPECT_EQ(job.variant, "frontier");
  EXPECT_EQ(sweep.jobs[2].seed, 7);
  EXPECT_THAT(sweep.command, HasSubstr(" --seeds 5-7 --only smoke/front"));
  options.only = "nowhere";
  EXPECT_THAT(Refusal("", options), HasSubstr("nothing to fly"));
}

TEST_F(SweepJobs, AnOptionalWorldThatIsNotThereIsLeftOutWithAWord) {
  const std::string gone = "[[world]]\nname = \"gone\"\nmission = \"smoke\"\nworld = \"nowhere.sdf\"\n";
  const Sweep sweep = Plan(gone + "optional = true\n");
  EXPECT_EQ(sweep.jobs.size(), 4u);
  EXPECT_THAT(sweep.left_out, ElementsAre("gone is left out: there is no nowhere.sdf."));
  EXPECT_THAT(Refusal(gone), HasSubstr("mission.world: no file 'nowhere.sdf'"));
}

TEST_F(SweepJobs, WhatCannotBeFlownIsRefusedBeforeAnythingIs) {
  EXPECT_THAT(Refusal("[[variant]]\nname = \"wrong\"\nset = [\"planner.alfa=1\"]\n"),
              HasSubstr("smoke/wrong: planner.alfa: unknown key; did you mean planner.alpha?"));
  EXPECT_THAT(Refusal("[[world]]\nmission = \"smok\"\n"), HasSubstr("did you mean smoke?"));
  SweepOptions options;
  options.sweep = "tabel2";
  try {
    PlanSweep(options);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("did you mean table2?"));
  }
}

TEST(ShellWord, IsReadByAShellAsItWas) {
  for (const std::string text : {"plain", "two words", "it's", "$HOME `id` \"x\" \\ * ;", "a=[1, 2]", ""})
    EXPECT_EQ(RunCommandLine("printf %s " + ShellWord(text)).output, text);
}

TEST(ShellLine, TakesAwayWhatIsLargeUnlessItIsToBeKept) {
  SweepJob job{"w", "v", 1, "a b", "run x"};
  EXPECT_THAT(ShellLine(job, "fly", false), HasSubstr("rm -f 'a b'/mission.lcmlog"));
  EXPECT_EQ(ShellLine(job, "fly", true).find("rm "), std::string::npos);
}

}  // namespace
}  // namespace citrine

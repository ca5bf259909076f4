#include "core/config/sweep_plan.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace citrine {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kPlan = R"(
[sweep]
name = "hops"
seeds = [4, 2]
set = ["mission.uavs=3"]
[[world]]
mission = "house"
[[world]]
name = "box"
title = "A box"
mission = "smoke"
world = "box.sdf"
optional = true
[[variant]]
name = "near"
[[variant]]
name = "far"
x = 5
set = ["planner.hop_min_m=5"]
)";

void ExpectRefused(const std::string& text, const std::string& because) {
  try {
    ParseSweep(text);
    FAIL() << "accepted, but: " << because;
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr(because));
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
  }
}

std::string With(const std::string& from, const std::string& to) {
  std::string text = kPlan;
  return text.replace(text.find(from), from.size(), to);
}

TEST(SweepPlan, IsReadWithWhatIsLeftOutFilledIn) {
  const SweepPlan plan = ParseSweep(kPlan);
  EXPECT_EQ(plan.sweep.title, "hops");
  EXPECT_EQ(plan.sweep.baseline, "near");
  EXPECT_THAT(plan.sweep.seeds, ElementsAre(4, 2));
  EXPECT_THAT(plan.sweep.set, ElementsAre("mission.uavs=3"));
  ASSERT_EQ(plan.worlds.size(), 2u);
  EXPECT_EQ(plan.worlds[0].name, "house");
  EXPECT_EQ(plan.worlds[0].title, "house");
  EXPECT_FALSE(plan.worlds[0].optional);
  EXPECT_EQ(plan.worlds[1].title, "A box");
  EXPECT_TRUE(plan.worlds[1].optional);
  ASSERT_EQ(plan.variants.size(), 2u);
  EXPECT_FALSE(plan.variants[0].x.has_value());
  EXPECT_EQ(*plan.variants[1].x, 5);
}

TEST(SweepPlan, IsRefusedInOneLineThatNamesTheKey) {
  ExpectRefused(With("seeds", "seedz"), "sweep.seedz: unknown key; did you mean sweep.seeds?");
  ExpectRefused(With("[4, 2]", "\"4\""), "sweep.seeds: must be a list of integers, is '4'");
  ExpectRefused(With("[4, 2]", "[4, 2.5]"), "sweep.seeds: must be a list of integers");
  ExpectRefused(With("[4, 2]", "[]"), "sweep.seeds");
  ExpectRefused(With("name = \"far\"", "name = \"near\""), "variant[1].name: there are two of 'near'");
  ExpectRefused(With("name = \"far\"", "name = \"../far\""), "variant[1].name: must be a name of letters");
  ExpectRefused(With("name = \"far\"", "title = \"far\""), "variant[1].name: must be a name");
  ExpectRefused(With("mission = \"smoke\"", "wrold = 1"),
                "world[1].wrold: unknown key; did you mean world[1].world?");
  ExpectRefused(With("mission = \"smoke\"\n", ""), "world[1].mission: missing");
  ExpectRefused(With("[[world]]\nmission = \"house\"", "[[worlds]]\nmission = \"house\""), "worlds: unknown");
  ExpectRefused(With("seeds = [4, 2]", "baseline = \"nera\""), "no variant 'nera'; did you mean near?");
  ExpectRefused("[sweep]\nname = \"x\"\n[[world]]\nmission = \"house\"\n", "variant: missing");
  ExpectRefused("[[world]]\nmission = \"house\"\n", "sweep: missing");
  ExpectRefused("sweep = 3", "sweep: must be a section");
  ExpectRefused("world = ", "not TOML");
}

TEST(SweepPlan, SeedsAreListsAndRanges) {
  EXPECT_THAT(ParseSeeds("1-3,7"), ElementsAre(1, 2, 3, 7));
  EXPECT_THAT(ParseSeeds("0"), ElementsAre(0));
  for (const char* wrong : {"", "a", "3-1", "1,,2", "1-", "-1", "1-100000", "1.5", "1 2"})
    EXPECT_THROW(ParseSeeds(wrong), ConfigError) << wrong;
}

TEST(SweepPlan, ThoseOfTheProjectAreRead) {
  int plans = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CITRINE_SOURCE_DIR "/missions/sweeps")) {
    std::ifstream in(entry.path());
    std::ostringstream text;
    text << in.rdbuf();
    EXPECT_NO_THROW(ParseSweep(text.str())) << entry.path();
    EXPECT_EQ(ParseSweep(text.str()).sweep.name, entry.path().stem());
    ++plans;
  }
  EXPECT_GE(plans, 5);
}

}  // namespace
}  // namespace citrine

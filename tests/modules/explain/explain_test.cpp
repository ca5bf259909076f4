#include "modules/explain/explain.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "modules/launch/mission_resolver.h"
#include "modules/launch/module_list.h"
#include "modules/runtime/in_process.h"

namespace citrine {
namespace {

using ::testing::HasSubstr;

/// The first seconds of the smoke mission, as they were said on the bus.
RecordedMission Fly() {
  RunOptions options;
  options.mission = CITRINE_SOURCE_DIR "/missions/smoke.toml";
  const std::string out = ::testing::TempDir() + "citrine_explain_test";
  std::filesystem::create_directories(out);
  options.overrides = {"mission.time_limit_s=8", "launch.pace=0", "launch.in_process=true",
                       "launch.out=" + out};
  RecordedMission mission;
  mission.config = ResolveMission(options).config;
  InProcessCallbacks callbacks;
  callbacks.on_event = [&](const LogEvent& event) { mission.events.push_back(event); };
  RunInProcess(mission.config, ModuleList(), callbacks);
  std::filesystem::remove_all(out);
  std::sort(mission.events.begin(), mission.events.end());
  return mission;
}

class Explain : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { mission = std::make_unique<RecordedMission>(Fly()); }
  static void TearDownTestSuite() { mission.reset(); }
  static inline std::unique_ptr<RecordedMission> mission;
};

TEST_F(Explain, MakesTheRecordedDecisionAgain) {
  for (const int uav : {1, 2}) {
    const Explanation explanation = citrine::Explain(*mission, uav, 2, 5);
    ASSERT_TRUE(explanation.found);
    EXPECT_TRUE(explanation.as_recorded);
    EXPECT_THAT(explanation.text, HasSubstr("UAV " + std::to_string(uav) + ", selection 2 at "));
    EXPECT_THAT(explanation.text, HasSubstr("chosen: "));
  }
}

TEST_F(Explain, ListsScoresThatAddUpFromTheHighestDown) {
  const Explanation explanation = citrine::Explain(*mission, 1, 2, 8);
  std::istringstream text(explanation.text);
  int rows = 0, chosen = 0;
  double last = 1e9;
  for (std::string line; std::getline(text, line);) {
    int rank = 0;
    double total = 0, information = 0, navigation = 0, coordination = 0;
    if (std::sscanf(line.c_str() + 1, "%d %lf %lf %lf %lf", &rank, &total, &information, &navigation,
                    &coordination) != 5)
      continue;
    EXPECT_EQ(rank, ++rows);
    EXPECT_NEAR(total, information + navigation + 2 * coordination, 3e-4);  // of four decimals each
    EXPECT_LE(total, last);
    last = total;
    chosen += line.front() == '>';
  }
  EXPECT_GT(rows, 3);
  EXPECT_EQ(chosen, 1);
}

TEST_F(Explain, DrawsTheCandidatesIntoTheScene) {
  const viz::Image second = citrine::Explain(*mission, 1, 2, 5).picture,
                   third = citrine::Explain(*mission, 1, 3, 5).picture;
  ASSERT_GT(second.width, 100);
  EXPECT_EQ(second.width, third.width);
  EXPECT_NE(second.bgr, third.bgr);
}

TEST_F(Explain, SaysHowManyDecisionsThereAreWhereThereIsNoSuchOne) {
  const Explanation explanation = citrine::Explain(*mission, 1, 9999, 5);
  EXPECT_FALSE(explanation.found);
  EXPECT_GT(explanation.decisions, 1);
  EXPECT_LT(explanation.decisions, 100);
}

}  // namespace
}  // namespace citrine

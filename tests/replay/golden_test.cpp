#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include <gtest/gtest.h>

#include "modules/launch/module_list.h"
#include "modules/replay/comparison.h"
#include "modules/replay/recorded_mission.h"
#include "modules/replay/replay.h"
#include "modules/replay/said_by.h"
#include "tests/replay/golden_missions.h"
#include "tests/replay/processor_kind.h"
#include "viz/read_png.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

ModuleKind KindNamed(const std::string& name) {
  for (const ModuleKind& kind : ModuleList())
    if (kind.name == name) return kind;
  throw std::invalid_argument(name);
}

bool IsRecordedOnThisKindOfProcessor() {
  std::ifstream in(test::GoldenFolder("processor.txt"));
  std::string kind;
  std::getline(in, kind);
  return kind == test::ProcessorKind();
}

/// What one module said in a golden mission, was recorded of it, and says now.
struct Heard {
  std::vector<LogEvent> recorded, said;
  std::string error;
};

Heard ReplayGolden(const RecordedMission& mission, const std::string& module, int uav,
                   const MissionConfig& config) {
  const Replayed replayed = Replay(mission.events, config, KindNamed(module), uav);
  Heard heard{{}, replayed.said, replayed.error};
  std::copy_if(mission.events.begin(), mission.events.end(), std::back_inserter(heard.recorded),
               [&](const LogEvent& event) {
                 return SaidBy({module, uav}, event);
               });
  return heard;
}

RecordedMission ReadGolden(const std::string& name) {
  return ReadMission(test::GoldenFolder(name) + "/mission.lcmlog");
}

class GoldenLog : public ::testing::TestWithParam<std::string> {
 protected:
  /// Every instance of a module: twice the same to the bit, and what was recorded, as far as a replay can
  /// tell: on another kind of processor up to the first decision that differs.
  void ExpectAsRecorded(const std::string& module, int first_uav, int last_uav) {
    const RecordedMission mission = ReadGolden(GetParam());
    for (int uav = first_uav; uav <= last_uav; ++uav) {
      const Heard once = ReplayGolden(mission, module, uav, mission.config);
      EXPECT_EQ(once.error, "");
      EXPECT_GT(once.recorded.size(), 20u) << "the recording says nothing of " << module;
      EXPECT_EQ(once.said, ReplayGolden(mission, module, uav, mission.config).said);
      const Comparison comparison = Compare(once.recorded, once.said, kOtherProcessor);
      const bool may_decide_otherwise = !IsRecordedOnThisKindOfProcessor() && comparison.first_is_decision;
      if (comparison.first && may_decide_otherwise)
        std::cout << "on this processor: " << comparison.first->Text() << "\n";
      else if (comparison.first)
        ADD_FAILURE() << module << " " << uav << ": " << comparison.first->Text() << "\n"
                      << comparison.different << " of " << comparison.recorded
                      << " messages differ. If they are meant to: logs/golden/record";
    }
  }
  int uavs() const { return ReadGolden(GetParam()).config.mission.uavs; }
};

INSTANTIATE_TEST_SUITE_P(Missions, GoldenLog, ::testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const auto& mission : test::GoldenMissions()) names.push_back(mission.name);
                           return names;
                         }()),
                         [](const auto& name) { return name.param; });

TEST_P(GoldenLog, IsWhole) {
  const RecordedMission mission = ReadGolden(GetParam());
  EXPECT_EQ(mission.flaws.damaged, 0);
  EXPECT_EQ(mission.flaws.repeated, 0);
  EXPECT_EQ(mission.flaws.missing, 0);
  EXPECT_TRUE(mission.config.lockstep());
}

TEST_P(GoldenLog, IsWhatMapFusionSays) { ExpectAsRecorded("map_fusion", 0, 0); }
TEST_P(GoldenLog, IsWhatTheViewPlannersSay) { ExpectAsRecorded("view_planner", 1, uavs()); }
TEST_P(GoldenLog, IsWhatTheTrajectorySmoothersSay) { ExpectAsRecorded("trajectory_smoother", 1, uavs()); }

TEST_P(GoldenLog, IsWhatTheTopdownRendererDraws) {
  const RecordedMission mission = ReadGolden(GetParam());
  const fs::path out = fs::path(::testing::TempDir()) / ("citrine_golden_" + GetParam());
  std::vector<std::string> pictures;
  for (const char* run : {"a", "b"}) {
    MissionConfig config = mission.config;
    config.launch.out = out / run;
    fs::create_directories(config.launch.out);
    EXPECT_EQ(ReplayGolden(mission, "topdown_renderer", 0, config).error, "");
    pictures.push_back(config.launch.out + "/topdown.png");
  }
  EXPECT_EQ(viz::ComparePngs(pictures[0], pictures[1]).pixels, 0);
  if (IsRecordedOnThisKindOfProcessor()) {
    EXPECT_EQ(viz::ComparePngs(pictures[0], test::GoldenFolder(GetParam()) + "/topdown.png").pixels, 0);
  }
  fs::remove_all(out);
}

TEST(GoldenLogs, AreSmall) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(test::GoldenFolder("")))
    if (entry.is_regular_file()) bytes += entry.file_size();
  EXPECT_LT(bytes, 6'000'000u);
}

TEST(GoldenLogs, ShowAModuleThatDecidesOtherwise) {
  const RecordedMission mission = ReadGolden("smoke");
  MissionConfig config = mission.config;
  config.quality.d_star_m = 3;
  const Heard heard = ReplayGolden(mission, "view_planner", 1, config);
  const Comparison comparison = Compare(heard.recorded, heard.said, kOtherProcessor);
  ASSERT_TRUE(comparison.first);
  EXPECT_TRUE(comparison.first_is_decision) << comparison.first->Text();
}

TEST(GoldenLogs, ShowAMapThatIsAVoxelOfTruncationOff) {
  const RecordedMission mission = ReadGolden("smoke");
  MissionConfig config = mission.config;
  config.map.truncation_m += 0.25;
  const Heard heard = ReplayGolden(mission, "map_fusion", 0, config);
  const Comparison comparison = Compare(heard.recorded, heard.said, kOtherProcessor);
  ASSERT_TRUE(comparison.first);
  EXPECT_FALSE(comparison.first_is_decision) << comparison.first->Text();
}

}  // namespace
}  // namespace citrine

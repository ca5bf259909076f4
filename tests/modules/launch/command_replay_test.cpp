#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "modules/channels.h"
#include "modules/runtime/log_reader.h"
#include "modules/runtime/log_writer.h"
#include "tests/support/citrine_command.h"
#include "tests/support/scratch_folder.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kGolden = CITRINE_SOURCE_DIR "/logs/golden/smoke_three_uavs/mission.lcmlog";

class ReplayCommand : public ::testing::Test {
 protected:
  /// A copy of the golden log in which `change` may alter, and lose, messages.
  template <class Change>
  std::string Changed(const Change& change) const {
    const std::string path = folder_ / "changed.lcmlog";
    LogWriter log(path);
    for (LogEvent& event : ReadInOrder(kGolden))
      if (change(event)) log.Write(event);
    log.Flush();
    return path;
  }

  const ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
};

TEST_F(ReplayCommand, NamesChannelTimeAndFieldOfTheFirstDifferenceAndExitsWithThree) {
  std::int64_t changed = 0;
  const std::string log = Changed([&](LogEvent& event) {
    if (event.channel != channels::kPath.Of(2)) return true;
    citrine_lcm::path_t path{};
    path.decode(event.bytes.data(), 0, static_cast<int>(event.bytes.size()));
    path.goal_yaw_rad += 0.5;
    event.bytes = Bus::ToBytes(path);
    ++changed;
    return true;
  });
  ASSERT_GT(changed, 0);
  const CommandResult replay = RunCitrine("replay " + log + " --into view_planner");
  EXPECT_EQ(replay.exit_code, 3) << replay.output;
  EXPECT_THAT(replay.output, HasSubstr(std::to_string(changed) + " of "));
  EXPECT_THAT(replay.output,
              ::testing::ContainsRegex("UAV2_PATH at t = [0-9.]+ s, message 1: goal_yaw_rad is "));
}

TEST_F(ReplayCommand, SaysWhatIsDamagedOrMissingInALogAndLives) {
  std::int64_t states = 0;
  const std::string log = Changed([&](const LogEvent& event) {
    return event.channel != channels::kUavState.Of(1) || ++states % 10 != 0;
  });
  fs::resize_file(log, fs::file_size(log) - 10);
  const CommandResult replay = RunCitrine("replay " + log + " --into trajectory_smoother");
  EXPECT_THAT(replay.output, HasSubstr("1 damaged places of the log were skipped"));
  EXPECT_THAT(replay.output, HasSubstr(std::to_string(states / 10) + " messages are missing in the log"));
  EXPECT_THAT(replay.output, HasSubstr("trajectory_smoother (UAV 3): "));
}

TEST_F(ReplayCommand, DrawsALogIntoAFolder) {
  const CommandResult replay = RunCitrine("replay " + kGolden + " --into topdown_renderer --video --out " +
                                          (folder_ / "drawn").string());
  EXPECT_THAT(replay.output, HasSubstr("topdown.png"));
  EXPECT_TRUE(fs::exists(folder_ / "drawn/topdown.png"));
  EXPECT_GT(fs::file_size(folder_ / "drawn/topdown.mp4"), 10'000u);
}

TEST_F(ReplayCommand, PlaysOnABusWithoutAModule) {
  const CommandResult play =
      RunCommandLine("LCM_DEFAULT_URL=memq:// " CITRINE_BIN_DIR "/launch replay " + kGolden + " --speed 100");
  EXPECT_EQ(play.exit_code, 0) << play.output;
}

TEST_F(ReplayCommand, SaysThatAMissionGetsNoFurther) {
  const std::string stalled = folder_ / "stalled.lcmlog";
  LogWriter log(stalled);
  for (const LogEvent& event : ReadInOrder(kGolden))
    if (event.channel == channels::kMissionConfig.name) log.Write(event);
  for (int second = 0; second <= 61; ++second) {
    citrine_lcm::clock_t clock{};
    clock.utime = FromSeconds(second);
    clock.seq = second + 1;
    clock.step = second;
    clock.dt_s = 1;
    clock.mission_id = "smoke-quality_adaptive-2";
    log.Write({clock.utime, channels::kClock.name, Bus::ToBytes(clock)});
    citrine_lcm::mission_progress_t progress{};
    progress.utime = clock.utime;
    progress.seq = second + 1;
    progress.surface_voxels = 100;
    progress.voxels_at_goal = 90;
    progress.elements_lqse = 12;
    log.Write({progress.utime, channels::kMissionProgress.name, Bus::ToBytes(progress)});
  }
  log.Flush();
  const CommandResult play = RunCommandLine("LCM_DEFAULT_URL=memq:// " CITRINE_BIN_DIR "/launch replay " +
                                            stalled + " --speed 1000");
  EXPECT_EQ(play.exit_code, 0) << play.output;
  EXPECT_THAT(play.output, HasSubstr("citrine: no new surface for 60 s: 12 active elements are left"));
}

TEST_F(ReplayCommand, TakesAResultFolderForTheLogInIt) {
  fs::copy(kGolden, folder_);
  fs::copy(fs::path(kGolden).parent_path() / "topdown.png", folder_);
  const CommandResult replay = RunCitrine("replay " + folder_.string() + " --into topdown_renderer");
  EXPECT_THAT(replay.output, HasSubstr("topdown.png"));
  EXPECT_THAT(replay.output, Not(HasSubstr("is not there to compare with")));
}

TEST_F(ReplayCommand, HasASisterThatExportsALogOrAResultFolder) {
  const std::string file = folder_ / "golden.mcap";
  const CommandResult exported = RunCitrine("export " + kGolden + " --to mcap --out " + file);
  EXPECT_EQ(exported.exit_code, 0) << exported.output;
  EXPECT_GT(fs::file_size(file), 100'000u);
  fs::copy(kGolden, folder_);
  EXPECT_EQ(RunCitrine("export " + folder_.string() + " --to mcap").exit_code, 0);
  EXPECT_EQ(fs::file_size(folder_ / "mission.mcap"), fs::file_size(file));
  EXPECT_EQ(RunCitrine("export " + kGolden + " --to bag").exit_code, 1);
}

TEST_F(ReplayCommand, RefusesWhatItCannotDo) {
  EXPECT_EQ(RunCitrine("replay " + kGolden + " --into uav_dynamics").exit_code, 1);
  EXPECT_EQ(RunCitrine("replay " + kGolden + " --speed 0").exit_code, 1);
  EXPECT_EQ(RunCitrine("replay " + kGolden + " --video").exit_code, 1) << "the bus draws nothing";
  for (const char* command : {"replay nowhere.lcmlog", "export nowhere.lcmlog --to mcap",
                              "explain nowhere.lcmlog --uav 1 --decision 1", "report nowhere.lcmlog"}) {
    const CommandResult absent = RunCitrine(command);
    EXPECT_EQ(absent.exit_code, 2) << command;
    EXPECT_EQ(absent.output, "citrine: nowhere.lcmlog: there is no such log\n");
  }
}

}  // namespace
}  // namespace citrine

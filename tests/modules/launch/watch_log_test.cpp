#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "modules/channels.h"
#include "modules/runtime/log_writer.h"
#include "tests/support/citrine_command.h"
#include "tests/support/scratch_folder.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

/// A log of ten seconds: CLOCK at 10 Hz, a UAV's state at 10 Hz, what is flown.
class WatchLog : public ::testing::Test {
 protected:
  void SetUp() override {
    citrine_lcm::mission_config_t flown{};
    flown.seq = 1;
    flown.mission_id = "yard-nearest_frontier-7";
    flown.commit = "0123abcd";
    flown.num_overrides = 1;
    flown.overrides = {"mission.uavs=1"};
    flown.toml = "[mission]\nname = \"yard\"\n";
    events_.push_back({0, "MISSION_CONFIG", Bus::ToBytes(flown)});
    for (int i = 0; i <= 100; ++i) {
      citrine_lcm::clock_t clock{};
      clock.utime = 100'000 * i;
      clock.seq = i + 1;
      clock.step = i;
      clock.dt_s = 0.1;
      clock.mission_id = flown.mission_id;
      if (i == 100) {
        clock.state = citrine_lcm::clock_t::DONE;
        clock.reason = "surface_complete";
      }
      events_.push_back({0, "CLOCK", Bus::ToBytes(clock)});
      citrine_lcm::uav_state_t state{};
      state.utime = clock.utime;
      state.seq = i + 1;
      state.p_WB[0] = 0.5 * i;
      events_.push_back({0, "UAV1_STATE", Bus::ToBytes(state)});
    }
  }
  void Write() const {
    LogWriter writer(log_);
    for (const LogEvent& event : events_) writer.Write(event);
  }

  const ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
  const std::string log_ = (folder_ / "mission.lcmlog").string();
  std::vector<LogEvent> events_;
};

TEST_F(WatchLog, InfoSaysWhatWasFlownAndHowOftenEachChannelSpoke) {
  Write();
  const CommandResult info = RunCitrine("log info " + folder_.string());
  EXPECT_EQ(info.exit_code, 0) << info.output;
  EXPECT_THAT(info.output, HasSubstr("203 events, until 00:10.000 of mission time"));
  EXPECT_THAT(info.output,
              HasSubstr("mission: yard-nearest_frontier-7\ncommit: 0123abcd\nset: mission.uavs=1\n"));
  EXPECT_THAT(info.output, HasSubstr("end: surface_complete\n"));
  EXPECT_THAT(info.output, ContainsRegex("UAV1_STATE +uav_state_t +101 +10\\.1 "));
}

TEST_F(WatchLog, CheckFindsASoundLogSound) {
  Write();
  const CommandResult check = RunCitrine("log check " + log_);
  EXPECT_EQ(check.exit_code, 0) << check.output;
  EXPECT_EQ(check.output, "sound; end: surface_complete\n");
}

TEST_F(WatchLog, CheckNamesDamageGapsAndWhatDoesNotDecode) {
  events_.erase(events_.begin() + 21, events_.begin() + 23);  // CLOCK and UAV1_STATE at 1.0 s
  events_[50].bytes.resize(30);
  Write();
  std::fstream file(log_, std::ios::binary | std::ios::in | std::ios::out);
  file.seekp(static_cast<std::streamoff>(fs::file_size(log_)) - 500);
  file.write("\0\0\0\0\0\0\0\0", 8);
  file.close();
  fs::resize_file(log_, fs::file_size(log_) - 5);
  const CommandResult check = RunCitrine("log check " + log_);
  EXPECT_EQ(check.exit_code, 3) << check.output;
  EXPECT_THAT(check.output, HasSubstr("CLOCK at 00:01.100: 1 messages before it are missing"));
  EXPECT_THAT(check.output, HasSubstr("does not decode: cut short"));
  EXPECT_THAT(check.output, ContainsRegex("mission.lcmlog at byte [0-9]+: [0-9]+ damaged bytes skipped"));
  const CommandResult info = RunCitrine("log info " + log_);
  EXPECT_EQ(info.exit_code, 0);
  EXPECT_THAT(info.output,
              ContainsRegex("[1-9] damaged places skipped, [0-9]+ messages missing, [12] that do not"));
  for (const char* command : {"top ", "echo UAV1_STATE "})
    EXPECT_THAT(
        RunCitrine(command + log_).output,
        ContainsRegex("[1-9] damaged places of the log were skipped; ./citrine log check names them"));
}

TEST_F(WatchLog, CutKeepsATimeAndChannelsAndWhatWasFlown) {
  Write();
  const std::string piece = (folder_ / "piece.lcmlog").string();
  EXPECT_EQ(
      RunCitrine("log cut " + log_ + " " + piece + " --from 2 --to 3 --channels 'UAV._STATE'").exit_code, 0);
  const CommandResult info = RunCitrine("log info " + piece);
  EXPECT_THAT(info.output, HasSubstr("12 events, until 00:03.000"));
  EXPECT_THAT(info.output, HasSubstr("mission: yard-nearest_frontier-7"));
  EXPECT_THAT(info.output, Not(HasSubstr("CLOCK  ")));
  EXPECT_EQ(RunCitrine("log cut " + log_ + " " + piece).exit_code, 2) << "nothing is written over";
}

TEST_F(WatchLog, EchoDecodesAChannelForPeopleAndForPrograms) {
  Write();
  const CommandResult text = RunCitrine("echo UAV1_STATE " + log_ + " --count 1");
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_THAT(text.output, HasSubstr("UAV1_STATE  uav_state_t  t 00:00.000\n"));
  EXPECT_THAT(text.output, HasSubstr("  v_W [m/s]  0  0  0\n"));
  const CommandResult json = RunCitrine("echo 'UAV[0-9]_STATE' " + log_ + " --json | tail -n 1");
  EXPECT_EQ(nlohmann::json::parse(json.output)["p_WB"][0], 50);
}

TEST_F(WatchLog, EchoOfAChannelThatIsNotThereNamesTheNearest) {
  Write();
  const CommandResult echo = RunCitrine("echo UAV1_STAT " + log_);
  EXPECT_EQ(echo.exit_code, 2);
  EXPECT_THAT(echo.output, HasSubstr("did you mean UAV1_STATE?"));
}

TEST_F(WatchLog, TopShowsALogAndAnyChannelOfIt) {
  events_.push_back({0, "SOMEBODYS", {1, 2, 3}});
  Write();
  const CommandResult top = RunCitrine("top " + log_);
  EXPECT_EQ(top.exit_code, 0);
  EXPECT_THAT(top.output, ContainsRegex("CLOCK +clock_t +101 "));
  EXPECT_THAT(top.output, ContainsRegex("SOMEBODYS +\\? +1 "));
}

TEST_F(WatchLog, WhatIsNotThereIsSaidInOneLine) {
  for (const char* command : {"log info ", "log check ", "top ", "echo CLOCK "}) {
    const CommandResult result = RunCitrine(command + (folder_ / "none").string());
    EXPECT_EQ(result.exit_code, 2) << command;
    EXPECT_THAT(result.output, HasSubstr("none: there is no such log"));
  }
  for (const char* command : {"top", "echo CLOCK"}) {
    const CommandResult result = RunCitrine(std::string(command) + " --run " + folder_.string());
    EXPECT_EQ(result.exit_code, 2) << command;
    EXPECT_THAT(result.output, HasSubstr("no mission flies into this folder now"));
  }
}

}  // namespace
}  // namespace citrine

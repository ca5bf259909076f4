#include "modules/replay/replay.h"

#include <gtest/gtest.h>

#include "modules/codec/clock.h"
#include "modules/codec/mission_config_text.h"
#include "modules/replay/comparison.h"
#include "modules/replay/play.h"
#include "modules/replay/recorded_mission.h"
#include "modules/replay/said_by.h"
#include "modules/runtime/log_writer.h"
#include "tests/modules/replay/recorded_words.h"

namespace citrine {
namespace {

LogEvent RecordedClock(std::int64_t step, bool last = false) {
  Clock clock;
  clock.utime = 20'000 * step;
  clock.step = step;
  clock.dt_s = 0.02;
  clock.state = last ? Clock::State::kDone : Clock::State::kRunning;
  clock.mission_id = "toy-1";
  return test::Recorded(channels::kClock.name, clock.utime, step + 1, Encode(clock));
}

/// Says as its path how far UAV 1 had been when it began the step.
class Follower : public Module {
 public:
  static constexpr const char* kName = "view_planner";
  static constexpr const char* kSummary = "";
  static constexpr bool kHearsMap = false;
  static constexpr bool kPerUav = true;

  explicit Follower(const ModuleContext& context)
      : bus_(context.bus),
        states_(bus_.Hear(channels::kUavState, context.uav)),
        own_(bus_.Hear(channels::kPath, context.uav)) {}
  void Tick(const Step& step) override {
    for (const auto& entry : states_->Take()) x_m_ = entry.message.p_WB[0];
    own_heard_ += own_->Take().size();
    if (x_m_ < 0) throw std::runtime_error("a negative place");
    citrine_lcm::path_t path{};
    path.path_id = step.last ? 1000 : static_cast<std::int64_t>(own_heard_);
    path.goal_yaw_rad = x_m_;
    bus_.Publish(channels::kPath, 1, path);
  }

 private:
  Bus& bus_;
  std::shared_ptr<Inbox<citrine_lcm::uav_state_t>> states_;
  std::shared_ptr<Inbox<citrine_lcm::path_t>> own_;
  std::size_t own_heard_ = 0;
  double x_m_ = 0;
};

citrine_lcm::path_t PathOf(const LogEvent& event) {
  citrine_lcm::path_t path{};
  EXPECT_GT(path.decode(event.bytes.data(), 0, static_cast<int>(event.bytes.size())), 0);
  return path;
}

TEST(Replay, LetsAModuleHearInEachStepWhatWasSaidBeforeItAndItsOwnWordsOnce) {
  const std::vector<LogEvent> events{
      RecordedClock(0), test::RecordedPath(0, 1, 99),      test::RecordedState(0, 1, 5),
      RecordedClock(1), test::RecordedState(20'000, 2, 6), RecordedClock(2, true)};
  const Replayed replayed = Replay(events, MissionConfig(), KindOf<Follower>(), 1);
  EXPECT_EQ(replayed.error, "");
  EXPECT_EQ(replayed.steps, 3);
  ASSERT_EQ(replayed.said.size(), 3u);
  EXPECT_EQ(PathOf(replayed.said[0]).goal_yaw_rad, 0);
  EXPECT_EQ(PathOf(replayed.said[1]).goal_yaw_rad, 5);
  EXPECT_EQ(PathOf(replayed.said[1]).path_id, 1) << "what it said in replay, not what was recorded of it";
  EXPECT_EQ(PathOf(replayed.said[2]).goal_yaw_rad, 6);
  EXPECT_EQ(PathOf(replayed.said[2]).path_id, 1000) << "the last step is the last";
}

TEST(Replay, TellsOfAModuleThatDies) {
  const Replayed replayed = Replay({RecordedClock(0), test::RecordedState(0, 1, -1), RecordedClock(1)},
                                   MissionConfig(), KindOf<Follower>(), 1);
  EXPECT_EQ(replayed.error, "view_planner (UAV 1): a negative place");
  EXPECT_EQ(replayed.steps, 1);
}

TEST(SaidBy, GoesByTheChannelTable) {
  const LogEvent path = test::RecordedPath(0, 1, 1);
  EXPECT_TRUE(SaidBy({"view_planner", 1}, path));
  EXPECT_FALSE(SaidBy({"view_planner", 2}, path));
  EXPECT_FALSE(SaidBy({"trajectory_smoother", 1}, path));
  citrine_lcm::fleet_assignment_t assignment{};
  assignment.sender = 2;
  const LogEvent correction = test::Recorded(channels::kFleetAssignment.name, 0, 1, assignment);
  EXPECT_TRUE(SaidBy({"view_planner", 2}, correction));
  EXPECT_FALSE(SaidBy({"view_planner", 1}, correction));
  EXPECT_TRUE(SaidBy({"map_fusion", 0}, {0, channels::kMapSummary.name, {}}));
  EXPECT_FALSE(SaidBy({"topdown_renderer", 0}, {0, channels::kMapSummary.name, {}}));
}

TEST(Play, SaysEveryMessageOfARecordingAsItIs) {
  Transport transport("memq://");
  std::vector<LogEvent> heard;
  const auto all = transport.Subscribe(".*", 0, [&](const std::string& channel, const void* bytes, int size) {
    const auto* first = static_cast<const std::uint8_t*>(bytes);
    heard.push_back({0, channel, {first, first + size}});
  });
  const std::vector<LogEvent> events{RecordedClock(0), test::RecordedState(0, 1, 5), RecordedClock(1)};
  Play(events, transport, 10, [](const LogEvent&) { return true; });
  transport.Handle(0);
  EXPECT_EQ(heard, events);
}

TEST(RecordedMission, IsReadFromItsLogAndRefusedWithoutAConfiguration) {
  const std::string path = ::testing::TempDir() + "citrine_recorded_mission.lcmlog";
  MissionConfigText text;
  text.mission_id = "yard-1";
  text.toml = "[mission]\nname = \"yard\"\nuavs = 2\n";
  text.overrides = {"mission.uavs=4"};
  {
    LogWriter log(path);
    log.Write(RecordedClock(0));
    log.Write(test::Recorded(channels::kMissionConfig.name, 0, 1, Encode(text)));
  }
  const RecordedMission mission = ReadMission(path);
  EXPECT_EQ(mission.config.mission.name, "yard");
  EXPECT_EQ(mission.config.mission.uavs, 4);
  EXPECT_EQ(mission.events.size(), 2u);
  LogWriter(path).Write(RecordedClock(0));
  EXPECT_THROW(ReadMission(path), std::runtime_error);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace citrine

#include "modules/mission_report/flight_record_reader.h"

#include <gtest/gtest.h>

#include "modules/codec/clock.h"
#include "modules/codec/fleet_assignment.h"
#include "modules/codec/module_health.h"
#include "modules/codec/uav_state.h"
#include "tests/modules/mission_report/recorder.h"
#include "tests/support/state_at.h"

namespace citrine {
namespace {

TEST(FlightRecordReader, KeepsTheStatesOfEveryUavInOrder) {
  Recorder recorder;
  for (int k = 0; k < 3; ++k)
    for (const int uav : {2, 1})
      recorder.Say(channels::kUavState, uav, k * 20'000,
                   Encode(StateAt(k * 20'000, {1.0 * k, 2.0 * uav, 3})));
  const Recording recording = ReadRecording(recorder.events());
  ASSERT_EQ(recording.flight.uavs.size(), 2u);
  ASSERT_EQ(recording.flight.uavs[1].states.size(), 3u);
  EXPECT_EQ(recording.flight.uavs[1].states[2].X_WB.p, Eigen::Vector3d(2, 4, 3));
  EXPECT_EQ(recording.flight.uavs[1].states[2].utime, 40'000);
}

TEST(FlightRecordReader, CountsAPlanOnceHoweverOftenItIsSaid) {
  Recorder recorder;
  FleetAssignment assignment;
  assignment.sender = 1;
  assignment.centroid_W_by_uav = {{1, 2, 3}, {4, 5, 6}};
  for (const std::int64_t plan : {17, 17, 33, 17}) {
    assignment.plan_id = plan;
    recorder.Say(channels::kFleetAssignment, 0, Encode(assignment));
  }
  EXPECT_EQ(ReadRecording(recorder.events()).flight.assignments.size(), 2u);
}

TEST(FlightRecordReader, JoinsTheSamplesOfAllModulesAndAddsTheirLosses) {
  Recorder recorder;
  ModuleHealth health;
  health.name = "view_planner";
  const auto say = [&](int uav, std::int64_t lost, std::int64_t kb, std::vector<float> samples) {
    health.uav = uav;
    health.lost = lost;
    health.peak_memory_kb = kb;
    health.samples = {{"replan_ms", std::move(samples)}};
    recorder.Say(channels::kModuleHealth, 0, Encode(health));
  };
  say(1, 2, 100, {1, 2});
  say(2, 1, 300, {3});
  say(1, 5, 200, {4});
  const Recording recording = ReadRecording(recorder.events());
  EXPECT_EQ(recording.flight.samples.at("replan_ms"), (std::vector<float>{1, 2, 3, 4}));
  EXPECT_EQ(recording.flight.messages_lost, 6);  // 5 of UAV 1's last word and 1 of UAV 2's
  EXPECT_EQ(recording.peak_memory_kb_by_module.at("view_planner/1"), 200);
}

TEST(FlightRecordReader, LeavesOutAndCountsWhatDoesNotDecode) {
  Recorder recorder;
  Clock clock;
  clock.utime = 60'000;
  clock.dt_s = 0.02;
  clock.step = 3;
  clock.state = Clock::State::kDone;
  clock.reason = "time_limit";
  clock.mission_id = "m";
  recorder.Say(channels::kClock, 60'000, Encode(clock));
  recorder.SayBytes("UAV1_STATE", 0, {1, 2, 3});
  recorder.SayBytes("MAP_SUMMARY", 0, std::vector<std::uint8_t>(40, 7));
  recorder.SayBytes("UAV1_", 0, {1});
  recorder.SayBytes("UAV99999999999_STATE", 0, {1});
  recorder.SayBytes("ANOTHER", 0, {1, 2});
  const Recording recording = ReadRecording(recorder.events());
  EXPECT_EQ(recording.messages_bad, 2);
  EXPECT_EQ(recording.stop_reason, "time_limit");
  EXPECT_EQ(recording.flight.end, 60'000);
  EXPECT_EQ(recording.flight.bytes_by_channel.at("ANOTHER"), 2);
}

}  // namespace
}  // namespace citrine

#include <gtest/gtest.h>

#include "modules/codec/bad_message.h"
#include "modules/codec/clock.h"
#include "modules/codec/mission_config_text.h"
#include "modules/codec/module_health.h"
#include "modules/codec/step_done.h"
#include "tests/modules/codec/over_the_wire.h"

namespace citrine {
namespace {

TEST(ClockCodec, LosesNothing) {
  const Clock said{20000, 1, 0.02, 2.5, Clock::State::kDone, "house-racer-3", "time_limit"};
  const Clock heard = Decode(OverTheWire(Encode(said)));
  EXPECT_EQ(heard.utime, 20000);
  EXPECT_EQ(heard.step, 1);
  EXPECT_EQ(heard.dt_s, 0.02);
  EXPECT_EQ(heard.pace, 2.5);
  EXPECT_EQ(heard.state, Clock::State::kDone);
  EXPECT_EQ(heard.mission_id, "house-racer-3");
  EXPECT_EQ(heard.reason, "time_limit");
}

TEST(ClockCodec, RefusesTimeBeforeTheMissionAndUnknownStates) {
  EXPECT_THROW(Decode(Encode(Clock{0, -1, 0.02, 1, {}, "m", {}})), BadMessage);
  EXPECT_THROW(Decode(Encode(Clock{0, 0, 0, 1, {}, "m", {}})), BadMessage);
  auto message = Encode(Clock{0, 0, 0.02, 1, {}, "m", {}});
  message.state = 2;
  EXPECT_THROW(Decode(message), BadMessage);
}

TEST(StepDoneCodec, LosesNothing) {
  const StepDone said{7, "view_planner", 2, {{"UAV2_PATH", 3}, {"UAV2_FLEET_STATUS", 40}}};
  const StepDone heard = Decode(OverTheWire(Encode(said)));
  EXPECT_EQ(heard.step, 7);
  EXPECT_EQ(heard.module, "view_planner");
  EXPECT_EQ(heard.uav, 2);
  EXPECT_EQ(heard.last_seq, said.last_seq);
}

TEST(StepDoneCodec, RefusesAChannelThatIsNamedTwice) {
  auto message = Encode(StepDone{7, "view_planner", 2, {{"A", 3}, {"B", 4}}});
  message.channels[1] = "A";
  EXPECT_THROW(Decode(message), BadMessage);
}

TEST(MissionConfigCodec, LosesNothing) {
  const MissionConfigText said{"id", "[mission]\n", {"a.b=1", "c.d=2"}, "abc123", true};
  const MissionConfigText heard = Decode(OverTheWire(Encode(said)));
  EXPECT_EQ(heard.mission_id, "id");
  EXPECT_EQ(heard.toml, "[mission]\n");
  EXPECT_EQ(heard.overrides, said.overrides);
  EXPECT_EQ(heard.commit, "abc123");
  EXPECT_TRUE(heard.dirty);
  EXPECT_THROW(Decode(Encode(MissionConfigText{})), BadMessage);
}

ModuleHealth SomeHealth() {
  return {"map_fusion",
          1,
          ModuleHealth::State::kRunning,
          2,
          3.5,
          4,
          5,
          6,
          7,
          "an error",
          {{"integration_ms", {1.5f, 2.5f}}, {"none", {}}, {"views", {8.0f}}}};
}

TEST(ModuleHealthCodec, LosesNothing) {
  const ModuleHealth said = SomeHealth();
  const ModuleHealth heard = Decode(OverTheWire(Encode(said)));
  EXPECT_EQ(heard.name, "map_fusion");
  EXPECT_EQ(heard.uav, 1);
  EXPECT_EQ(heard.state, ModuleHealth::State::kRunning);
  EXPECT_EQ(heard.last_tick, 2);
  EXPECT_EQ(heard.worst_tick_ms, 3.5);
  EXPECT_EQ(heard.lost, 4);
  EXPECT_EQ(heard.bad, 5);
  EXPECT_EQ(heard.bytes_said, 6);
  EXPECT_EQ(heard.peak_memory_kb, 7);
  EXPECT_EQ(heard.last_error, "an error");
  EXPECT_EQ(heard.samples, said.samples);
}

TEST(ModuleHealthCodec, RefusesSamplesThatDoNotAddUp) {
  auto message = Encode(SomeHealth());
  message.num_samples[0] = 3;
  message.num_samples[2] = 1;
  EXPECT_THROW(Decode(message), BadMessage);
  message.num_samples[0] = -1;
  EXPECT_THROW(Decode(message), BadMessage);
  message = Encode(SomeHealth());
  message.num_samples[0] = 1;
  EXPECT_THROW(Decode(message), BadMessage);
}

}  // namespace
}  // namespace citrine

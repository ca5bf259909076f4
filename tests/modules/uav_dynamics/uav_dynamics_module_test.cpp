#include "modules/uav_dynamics/uav_dynamics_module.h"

#include <fstream>

#include <gtest/gtest.h>

#include "modules/channels.h"
#include "modules/codec/fleet_status.h"
#include "modules/codec/trajectory.h"
#include "modules/codec/uav_state.h"

namespace citrine {
namespace {

/// A bare floor, two UAVs, everything on one memq bus.
struct UavDynamics : testing::Test {
  MissionConfig config;
  Bus bus{"memq://"};
  Health health;
  std::shared_ptr<Inbox<citrine_lcm::uav_state_t>> states = bus.HearAll(channels::kUavState);
  std::unique_ptr<UavDynamicsModule> module;
  std::int64_t index = 0;

  UavDynamics() {
    const std::string world = testing::TempDir() + "uav_dynamics_floor.obj";
    std::ofstream(world) << "v -50 -50 0\nv 50 -50 0\nv 50 50 0\nv -50 50 0\nf 1 2 3\nf 1 3 4\n";
    config.mission.world = world;
    config.mission.uavs = 2;
    config.mission.spawns_m = {{0, 0, 3}, {10, 0, 3}};
    config.mission.time_limit_s = 60;
  }

  void Start() {
    module = std::make_unique<UavDynamicsModule>(ModuleContext{config, bus, health, 0, nullptr});
  }

  /// One step in lockstep. @return what UAV `uav` said in it
  UavState Tick(int uav = 1) {
    const Step step{index, FromSeconds(static_cast<double>(index) * config.dynamics.step_s), false};
    ++index;
    bus.BeginStep(step, true);
    module->Tick(step);
    while (bus.Handle(0) > 0) {
    }
    const Step next{index, FromSeconds(static_cast<double>(index) * config.dynamics.step_s), false};
    bus.BeginStep(next, true);
    UavState said;
    for (const auto& entry : states->Take())
      if (entry.uav == uav) said = Decode(entry.message);
    return said;
  }

  void Say(int uav, const FleetStatus& status) {
    bus.Publish(channels::kFleetStatus, uav, Encode(status));
    while (bus.Handle(0) > 0) {
    }
  }
};

TEST_F(UavDynamics, SaysWhereEachUavHoversFromTheFirstStepOn) {
  Start();
  for (int k = 0; k < 50; ++k) {
    const UavState said = Tick(2);
    ASSERT_EQ(said.utime, k * 20000);
    ASSERT_LT((said.X_WB.p - Eigen::Vector3d(10, 0, 3)).norm(), 0.02);
  }
}

TEST_F(UavDynamics, FliesWhatIsSaidOnceAndIgnoresWhatItKnows) {
  Start();
  Tick();
  Trajectory there = Hover({0, 1, 3}, 0, 0);
  there.segments[0].duration_s = 1;
  there.id = 2;
  Trajectory older = Hover({0, -1, 3}, 0, 0);
  older.segments[0].duration_s = 1;
  older.id = 1;
  for (const Trajectory& said : {there, older}) bus.Publish(channels::kTrajectory, 1, Encode(said));
  UavState last;
  for (int k = 0; k < 250; ++k) last = Tick();
  EXPECT_LT((last.X_WB.p - Eigen::Vector3d(0, 1, 3)).norm(), 0.02);
}

TEST_F(UavDynamics, FliesWhatASmootherSaysThatWasStartedAgain) {
  Start();
  Tick();
  Trajectory before = Hover({0, 1, 3}, 0, 0);
  before.id = 9;
  bus.Publish(channels::kTrajectory, 1, Encode(before));
  for (int k = 0; k < 100; ++k) Tick();
  Trajectory anew = Hover({0, -1, 3}, 0, 2'000'000);
  anew.id = 1;
  bus.Publish(channels::kTrajectory, 1, Encode(anew));
  UavState last;
  for (int k = 0; k < 250; ++k) last = Tick();
  EXPECT_LT((last.X_WB.p - Eigen::Vector3d(0, -1, 3)).norm(), 0.02);
}

TEST_F(UavDynamics, AddsLocalisationNoiseToWhatIsSaidAlone) {
  config.uav.localisation_noise_m = 0.1;
  Start();
  double sum = 0;
  constexpr int kSteps = 500;
  for (int k = 0; k < kSteps; ++k) sum += (Tick().X_WB.p - Eigen::Vector3d(0, 0, 3)).squaredNorm();
  // 3 axes x 0.1^2; the sample deviation of 1500 squares is 4 %, and were the noise fed back the body would
  // wander.
  EXPECT_NEAR(sum / kSteps, 0.03, 0.006);
}

TEST_F(UavDynamics, KnowsWhenTheSurfaceIsComplete) {
  Start();
  for (int k = 0; k < 10; ++k) Tick();
  FleetStatus done;
  done.no_view_left = true;
  Say(1, done);
  for (int k = 0; k < 150; ++k) Tick();
  EXPECT_FALSE(module->stop_reason());
  Say(2, done);
  for (int k = 0; k < 98; ++k) Tick();
  EXPECT_FALSE(module->stop_reason());
  for (int k = 0; k < 5; ++k) Tick();
  EXPECT_EQ(module->stop_reason(), "surface_complete");
}

TEST_F(UavDynamics, EndsAtTheTimeLimit) {
  config.mission.time_limit_s = 1;
  Start();
  for (int k = 0; k < 50; ++k) Tick();
  EXPECT_FALSE(module->stop_reason());
  Tick();
  EXPECT_EQ(module->stop_reason(), "time_limit");
}

TEST_F(UavDynamics, RefusesAFleetWithoutAPlaceForEach) {
  config.mission.spawns_m.pop_back();
  EXPECT_THROW(Start(), ConfigError);
}

}  // namespace
}  // namespace citrine

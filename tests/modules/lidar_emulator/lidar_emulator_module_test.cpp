#include "modules/lidar_emulator/lidar_emulator_module.h"

#include <gtest/gtest.h>

#include "modules/channels.h"
#include "modules/codec/lidar_scan.h"
#include "modules/codec/uav_state.h"

namespace citrine {
namespace {

constexpr Utime kStep = 20000;

MissionConfig Smoke() {
  MissionConfig config;
  config.mission.world = CITRINE_SOURCE_DIR "/worlds/smoke.sdf";
  config.mission.uavs = 3;
  config.lidar.model.cols = 64;
  return config;
}

/// One process with a lidar_emulator and somebody who says states.
class Flight {
 public:
  explicit Flight(const MissionConfig& config)
      : config_(config),
        scans_(bus_.HearAll(channels::kLidarScan)),
        module_({config_, bus_, health_, 0, nullptr}) {}

  struct Scan {
    Utime said;
    int uav;
    LidarScan scan;
  };

  /// Every UAV stands still; states are said in every step. @return the scans of the whole flight
  std::vector<Scan> Fly(int steps) {
    std::vector<Scan> heard;
    for (int k = 0; k < steps; ++k) {
      bus_.BeginStep({k, k * kStep}, true);
      for (auto& entry : scans_->Take())
        heard.push_back({entry.message.utime, entry.uav, Decode(entry.message)});
      module_.Tick({k, k * kStep});
      for (int uav = 1; uav <= config_.mission.uavs; ++uav) {
        UavState state;
        state.utime = k * kStep;
        state.X_WB.p = {3.0 * uav - 6, -5, 2.5};
        bus_.Publish(channels::kUavState, uav, Encode(state));
      }
      while (bus_.Handle(0) > 0) {
      }
    }
    return heard;
  }
  const Bus& bus() const { return bus_; }

 private:
  MissionConfig config_;
  Bus bus_{"memq://"};
  Health health_;
  std::shared_ptr<Inbox<citrine_lcm::lidar_scan_t>> scans_;
  LidarEmulatorModule module_;
};

TEST(LidarEmulatorModule, ScansAtItsRateWithTheUavsStaggeredOverThePeriod) {
  std::map<int, std::vector<Utime>> said;
  for (const auto& scan : Flight(Smoke()).Fly(52)) said[scan.uav].push_back(scan.said);
  ASSERT_EQ(said.size(), 3u);
  // 10 Hz; a third of 0.1 s is 1.67 steps, two thirds 3.33. The first state is heard in step 1, so UAV 1
  // begins there.
  for (const auto& [uav, phase] : std::map<int, Utime>{{1, 0}, {2, 2 * kStep}, {3, 3 * kStep}})
    for (std::size_t i = 1; i < said[uav].size(); ++i) EXPECT_EQ(said[uav][i] % 100000, phase) << uav;
  for (const auto& [uav, times] : said) EXPECT_NEAR(static_cast<double>(times.size()), 10, 1) << uav;
}

TEST(LidarEmulatorModule, SaysThePoseAndTimeOfTheStateThatWasScanned) {
  for (const auto& scan : Flight(Smoke()).Fly(20)) {
    EXPECT_EQ(scan.scan.measured, scan.said - kStep);
    EXPECT_TRUE(scan.scan.X_WS.p.isApprox(Eigen::Vector3d(3.0 * scan.uav - 6, -5, 2.5), 1e-6));
  }
}

TEST(LidarEmulatorModule, SeesTheNextUav) {
  for (const auto& scan : Flight(Smoke()).Fly(20)) {
    if (scan.uav != 2) continue;
    int near = 0;
    for (const float range_m : scan.scan.ranges_m)
      near += range_m > 2.6f && range_m < 2.75f;  // a sphere of 0.35 m, 3 m away
    EXPECT_GT(near, 4);
  }
}

TEST(LidarEmulatorModule, SaysTheSameForTheSameSeedAlone) {
  const auto ranges_m = [](int seed) {
    MissionConfig config = Smoke();
    config.mission.seed = seed;
    return Flight(config).Fly(10).back().scan.ranges_m;
  };
  EXPECT_EQ(ranges_m(1), ranges_m(1));
  EXPECT_NE(ranges_m(1), ranges_m(2));
}

TEST(LidarEmulatorModule, IsSilentBeforeItHearsAState) {
  const MissionConfig config = Smoke();
  Bus bus("memq://");
  Health health;
  LidarEmulatorModule module({config, bus, health, 0, nullptr});
  for (int k = 0; k < 20; ++k) {
    bus.BeginStep({k, k * kStep}, true);
    module.Tick({k, k * kStep});
  }
  EXPECT_EQ(bus.counts().bytes_said, 0);
}

TEST(LidarEmulatorModule, DropsAndCountsAStateThatIsNone) {
  const MissionConfig config = Smoke();
  Bus bus("memq://");
  Health health;
  LidarEmulatorModule module({config, bus, health, 0, nullptr});
  bus.BeginStep({0, 0}, true);
  citrine_lcm::uav_state_t message = Encode(UavState());
  message.q_WB[0] = std::numeric_limits<double>::quiet_NaN();
  bus.Publish(channels::kUavState, 1, message);
  while (bus.Handle(0) > 0) {
  }
  bus.BeginStep({1, kStep}, true);
  module.Tick({1, kStep});
  EXPECT_EQ(bus.counts().bad, 1);
}

}  // namespace
}  // namespace citrine

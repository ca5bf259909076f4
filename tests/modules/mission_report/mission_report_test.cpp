#include "modules/mission_report/mission_report.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/config/config_file.h"
#include "core/map/ply.h"
#include "modules/codec/clock.h"
#include "modules/codec/fleet_status.h"
#include "modules/codec/lidar_scan.h"
#include "modules/codec/mission_config_text.h"
#include "modules/codec/uav_state.h"
#include "modules/runtime/log_writer.h"
#include "sim/lidar/lidar_emulator.h"
#include "sim/world/world.h"
#include "tests/modules/mission_report/recorder.h"
#include "tests/support/scratch_folder.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

constexpr double kFlown_m = 6;
constexpr double kDuration_s = 6;

/// A floor of 12 x 12 m with a block of 2 m on it, as a mesh file.
const char* kWorldObj = R"(
o ground
v -6 -6 0
v 6 -6 0
v 6 6 0
v -6 6 0
f 1 2 3
f 1 3 4
o block
v -1 2 0
v 1 2 0
v 1 4 0
v -1 4 0
v -1 2 2
v 1 2 2
v 1 4 2
v -1 4 2
f 5 6 10
f 5 10 9
f 6 7 11
f 6 11 10
f 7 8 12
f 7 12 11
f 8 5 9
f 8 9 12
f 9 10 11
f 9 11 12
)";

std::string ReadText(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class MissionReport : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "block.obj") << kWorldObj;
    config_ = ParseMission(
        "[mission]\nname = \"block\"\nuavs = 1\nvolume_min_m = [-6, -6, 0]\nvolume_max_m = [6, 6, 6]\n"
        "spawns_m = [[-3, -2, 2.5]]\nworld = \"" +
            (folder_ / "block.obj").string() +
            "\"\n"
            "[map]\nvoxel_m = 0.25\n",
        {});
  }

  /// One UAV flies kFlown_m along x before the block at 1 m/s and scans twice a second.
  void Record() {
    Recorder recorder;
    recorder.Say(channels::kMissionConfig, 0,
                 Encode(MissionConfigText{"block-1", ToToml(config_), {}, "abc123", false}));
    const auto scene = std::make_shared<sim::RayScene>(sim::LoadWorld(config_.mission.world));
    const sim::LidarEmulator lidar(scene, config_.lidar.model, 0);
    Random random(1);
    for (int k = 0; k <= 50 * kDuration_s; ++k) {
      const Utime now = k * 20'000;
      UavState state;
      state.utime = now;
      state.X_WB.p = {-3 + kFlown_m * k / (50 * kDuration_s), -2, 2.5};
      state.v_W = {1, 0, 0};
      recorder.Say(channels::kUavState, 1, now, Encode(state));
      if (k % 25 == 0)
        recorder.Say(channels::kLidarScan, 1, now, Encode(lidar.Scan(now, state.X_WB, {}, random)));
      Clock clock;
      clock.utime = now;
      clock.step = k;
      clock.dt_s = 0.02;
      clock.mission_id = "block-1";
      if (k == 50 * kDuration_s) {
        clock.state = Clock::State::kDone;
        clock.reason = "surface_complete";
      }
      recorder.Say(channels::kClock, now, Encode(clock));
    }
    FleetStatus status;
    status.decisions = 4;
    recorder.Say(channels::kFleetStatus, 1, 1'000'000, Encode(status));
    LogWriter writer(log());
    for (const LogEvent& event : recorder.events()) writer.Write(event);
    writer.Flush();
  }

  std::string log() const { return folder_ / "mission.lcmlog"; }
  ReportInputs Inputs() const {
    ReportInputs inputs;
    inputs.config = config_;
    inputs.log_path = log();
    inputs.wall_time_s = 2;
    return inputs;
  }

  const ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
  MissionConfig config_;
};

TEST_F(MissionReport, OfATinyLogSaysWhatWasFlownAndSeen) {
  Record();
  const logs::Metrics m = WriteReport(folder_, Inputs());
  EXPECT_TRUE(m.completed);
  EXPECT_NEAR(*m.makespan_m, kFlown_m, 1e-9);
  EXPECT_DOUBLE_EQ(m.mission_time_s, kDuration_s);
  EXPECT_DOUBLE_EQ(*m.real_time_factor, kDuration_s / 2);
  EXPECT_EQ(*m.decisions, 4);
  EXPECT_EQ(*m.collisions, 0);
  EXPECT_EQ(*m.commit, "abc123");
  EXPECT_NEAR(*m.min_obstacle_clearance_m, 2.5, 1e-5);  // the ground; the block is further
  // Seen from one side only: more than the ground before it, less than all.
  EXPECT_GT(*m.coverage_pct, 50);
  EXPECT_LT(*m.coverage_pct, 95);
  EXPECT_GT(*m.precision_pct, 95);
  EXPECT_LT(*m.surface_error_mean_m, 0.05);  // a fifth of a voxel, without noise
  EXPECT_GT(*m.goal_coverage_pct, 20);
  EXPECT_LT(*m.goal_coverage_pct, *m.observable_coverage_pct);
  EXPECT_FALSE(m.min_uav_separation_m.has_value());
}

TEST_F(MissionReport, WritesItsFiles) {
  Record();
  WriteReport(folder_, Inputs());
  EXPECT_THAT(ReadText(folder_ / "metrics.json"),
              testing::HasSubstr("\"stop_reason\": \"surface_complete\""));
  EXPECT_THAT(ReadText(folder_ / "uav1.tum"), testing::StartsWith("0.000000 -3.000000 -2.000000 2.500000 "));
  EXPECT_THAT(ReadText(folder_ / "progress.csv"), testing::StartsWith("time_s,"));
  EXPECT_THAT(ReadText(folder_ / "report.html"), testing::HasSubstr("Surface complete after 0:06"));
}

TEST_F(MissionReport, TakesTheMeshOfTheFolderBeforeFusingAgain) {
  Record();
  WritePly(folder_ / "mesh.ply", TriMesh{});
  EXPECT_DOUBLE_EQ(*WriteReport(folder_, Inputs()).coverage_pct, 0);
}

TEST_F(MissionReport, IsTheSameTwice) {
  Record();
  WriteReport(folder_, Inputs());
  const std::string first = ReadText(folder_ / "metrics.json");
  WriteReport(folder_, Inputs());
  EXPECT_EQ(ReadText(folder_ / "metrics.json"), first);
}

TEST_F(MissionReport, LeavesTheTruthOutWhereTheWorldIsMissing) {
  Record();
  ReportInputs inputs = Inputs();
  inputs.config.mission.world = folder_ / "gone.obj";
  const logs::Metrics m = WriteReport(folder_, inputs);
  EXPECT_FALSE(m.coverage_pct.has_value());
  EXPECT_NEAR(*m.makespan_m, kFlown_m, 1e-9);
  EXPECT_THAT(ReadText(folder_ / "report.html"), testing::HasSubstr("gone.obj"));
}

TEST_F(MissionReport, FindsTheMissionInTheLogItself) {
  Record();
  EXPECT_EQ(ToToml(InputsFromLog(log()).config), ToToml(config_));
  EXPECT_THROW(InputsFromLog(folder_ / "none.lcmlog"), std::runtime_error);
}

}  // namespace
}  // namespace citrine

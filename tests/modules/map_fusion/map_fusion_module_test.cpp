#include "modules/map_fusion/map_fusion_module.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "core/map/ply.h"
#include "modules/codec/bad_message.h"
#include "modules/codec/lidar_scan.h"
#include "modules/codec/map_summary.h"
#include "modules/codec/point_cloud.h"
#include "modules/codec/uav_state.h"
#include "tests/support/analytic_scene.h"

namespace citrine {
namespace {

/// A base station, two UAVs that speak, and a hearer, on one bus in this process.
class MapFusion : public ::testing::Test {
 protected:
  MapFusion() {
    config_.mission.volume_min_m = Eigen::Vector3d(-8, -8, 0);
    config_.mission.volume_max_m = Eigen::Vector3d(8, 8, 5);
    config_.mission.spawns_m = {{-2, 0, 2.5}, {2, 0, 2.5}};
    config_.mission.uavs = 2;
    config_.launch.in_process = true;
    config_.map.rotation_s = 2;
    config_.launch.out = ::testing::TempDir() + "citrine_map_fusion_test";
    std::filesystem::create_directories(config_.launch.out);
    scene_.AddHalfSpace(Eigen::Vector3d::UnitZ(), 0);
    scene_.AddBox({-1, 3, 0}, {1, 5, 3});
  }
  ~MapFusion() override { std::filesystem::remove_all(config_.launch.out); }

  void Begin() {
    own_hearer_ = std::make_shared<MapHearer>(config_, station_);
    module_ = std::make_unique<MapFusionModule>(ModuleContext{config_, station_, health_, 0, own_hearer_});
  }
  /// One step of 20 ms; the UAVs say what they see every fifth, if they fly.
  void Tick(bool flying, bool last = false) {
    const Step step{++index_, index_ * 20'000, last};
    for (Bus* bus : {&uavs_, &station_, &listener_}) bus->BeginStep(step, true);
    if (flying && index_ % 5 == 0)
      for (int uav : {1, 2}) {
        const Pose X_WS{config_.mission.spawns_m[uav - 1] + Eigen::Vector3d(0, 0.002 * index_, 0),
                        Eigen::Quaterniond::Identity()};
        UavState state;
        state.utime = step.now;
        state.X_WB = X_WS;
        uavs_.Publish(channels::kUavState, uav, Encode(state));
        test::AnalyticScene seen = scene_;
        seen.AddSphere(config_.mission.spawns_m[2 - uav] + Eigen::Vector3d(0, 0.002 * index_, 0), 0.35);
        LidarScan scan = seen.Scan(X_WS);
        scan.measured = step.now;
        uavs_.Publish(channels::kLidarScan, uav, Encode(scan));
      }
    if (module_) module_->Tick(step);
    if (hearer_) hearer_->Update(step);
    while (uavs_.Handle(0) > 0) {
    }
  }

  MissionConfig config_;
  test::AnalyticScene scene_;
  std::shared_ptr<Transport> transport_ = std::make_shared<Transport>("memq://");
  Bus uavs_{transport_}, station_{transport_}, listener_{transport_};
  Health health_;
  std::shared_ptr<MapHearer> own_hearer_, hearer_;
  std::unique_ptr<MapFusionModule> module_;
  std::int64_t index_ = 0;
};

TEST_F(MapFusion, LetsAHearerHoldTheBaseStationsMap) {
  hearer_ = std::make_shared<MapHearer>(config_, listener_);
  Begin();
  for (int k = 0; k < 60; ++k) Tick(true);
  for (int k = 0; k < 60; ++k) Tick(false);
  EXPECT_GT(hearer_->map_version(), 0);
  EXPECT_EQ(hearer_->map_version(), own_hearer_->map_version());
  EXPECT_EQ(hearer_->map().Digest(), own_hearer_->map().Digest());
  const PlanningMap& map = hearer_->map();
  EXPECT_EQ(map.state(map.grid().Linear(map.grid().IndexOf({0.1, 2.9, 1.6}))), VoxelState::kOccupied);
  EXPECT_EQ(map.state(map.grid().Linear(map.grid().IndexOf({0.1, 1.9, 2.4}))), VoxelState::kEmpty);
}

TEST_F(MapFusion, KeepsTeammatesOutOfTheMap) {
  Begin();
  for (int k = 0; k < 100; ++k) Tick(k < 50);
  const PlanningMap& map = own_hearer_->map();
  int occupied = 0;
  for (std::size_t i = 0; i < map.grid().num_voxels(); ++i)
    if (const double z = map.grid().Centre(map.grid().FromLinear(i)).z(); z > 1 && z < 4)
      occupied += map.state(i) == VoxelState::kOccupied &&
                  scene_.Distance(map.grid().Centre(map.grid().FromLinear(i))) > 0.75;
  EXPECT_EQ(occupied, 0);
}

TEST_F(MapFusion, HasTheSameMapInWhateverOrderScansOfAnInstantArrive) {
  std::vector<std::uint64_t> digests;
  for (const bool reversed : {false, true}) {
    auto transport = std::make_shared<Transport>("memq://");
    Bus uavs(transport), station(transport);
    auto hearer = std::make_shared<MapHearer>(config_, station);
    MapFusionModule module(ModuleContext{config_, station, health_, 0, hearer});
    for (std::int64_t k = 1; k <= 60; ++k) {
      const Step step{k, k * 20'000, false};
      for (Bus* bus : {&uavs, &station}) bus->BeginStep(step, true);
      for (int i = 0; i < 2 && k % 5 == 0; ++i) {
        const int uav = reversed ? 2 - i : 1 + i;
        LidarScan scan = scene_.Scan({config_.mission.spawns_m[uav - 1] + Eigen::Vector3d(0, 0.01 * k, 0),
                                      Eigen::Quaterniond::Identity()});
        scan.measured = step.now;
        uavs.Publish(channels::kLidarScan, uav, Encode(scan));
      }
      module.Tick(step);
      while (uavs.Handle(0) > 0) {
      }
    }
    digests.push_back(hearer->map().Digest());
  }
  EXPECT_EQ(digests[0], digests[1]);
}

TEST_F(MapFusion, HearsPointCloudsInChunks) {
  Begin();
  const LidarScan scan = scene_.Scan({{-2, 0, 2.5}, Eigen::Quaterniond::Identity()});
  PointCloud cloud{.measured = 0, .X_WS = scan.X_WS, .range_min_m = 0.42, .range_max_m = 10, .points_S = {}};
  for (int row = 0; row < scan.model.rows; ++row)
    for (int col = 0; col < scan.model.cols; ++col)
      if (const float r = scan.ranges_m[row * scan.model.cols + col]; r > 0)
        cloud.points_S.push_back((scan.model.Direction(row, col) * r).cast<float>());
  for (int k = 0; k < 60; ++k) {
    if (k % 10 == 0) {
      cloud.measured = 1 + k;
      auto chunks = EncodeInMessages(cloud);
      ASSERT_GT(chunks.size(), 1u);
      std::reverse(chunks.begin(), chunks.end());
      for (const auto& chunk : chunks) uavs_.Publish(channels::kPointCloud, 1, chunk);
    }
    Tick(false);
  }
  const PlanningMap& map = own_hearer_->map();
  EXPECT_EQ(map.state(map.grid().Linear(map.grid().IndexOf({0.1, 2.9, 1.6}))), VoxelState::kOccupied);
  EXPECT_EQ(map.state(map.grid().Linear(map.grid().IndexOf({-1.5, 1.2, 2.1}))), VoxelState::kEmpty);
  // Beams that are missing carve nothing: above the horizon nothing was seen.
  EXPECT_EQ(map.state(map.grid().Linear(map.grid().IndexOf({-6, 0, 4}))), VoxelState::kUnknown);
  EXPECT_EQ(station_.counts().bad, 0);
}

TEST(CloudChunks, TakeASweepThatLostAChunkOnceTheNextBegins) {
  PointCloud cloud{.measured = 5, .X_WS = {}, .range_min_m = 0.42, .range_max_m = 10, .points_S = {}};
  cloud.points_S.assign(6000, Eigen::Vector3f(1, 2, 3));
  const auto first = EncodeInMessages(cloud);
  ASSERT_EQ(first.size(), 3u);
  CloudChunks chunks;
  EXPECT_FALSE(chunks.Hear(1, first[0]));
  EXPECT_FALSE(chunks.Hear(1, first[0]));  // twice is once
  EXPECT_FALSE(chunks.Hear(1, first[2]));
  cloud.measured = 6;
  const auto second = EncodeInMessages(cloud);
  const auto cut = chunks.Hear(1, second[0]);
  ASSERT_TRUE(cut);
  EXPECT_EQ(cut->measured, 5);
  EXPECT_EQ(static_cast<int>(cut->points_S.size()), first[0].num_points + first[2].num_points);
  EXPECT_FALSE(chunks.Hear(2, second[1]));  // another UAV's
  EXPECT_FALSE(chunks.Hear(1, second[1]));
  const auto whole = chunks.Hear(1, second[2]);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->points_S.size(), 6000u);
  EXPECT_FALSE(chunks.Hear(1, second[2]));
  EXPECT_THROW(chunks.Hear(1, first[1]), BadMessage);
}

TEST_F(MapFusion, FillsAHearerThatJoinsLate) {
  Begin();
  for (int k = 0; k < 60; ++k) Tick(true);
  hearer_ = std::make_shared<MapHearer>(config_, listener_);
  EXPECT_EQ(hearer_->map_version(), -1);
  for (int k = 0; k < 200; ++k) Tick(false);
  EXPECT_EQ(hearer_->map_version(), own_hearer_->map_version());
  EXPECT_EQ(hearer_->map().Digest(), own_hearer_->map().Digest());
}

TEST_F(MapFusion, GoesOnFromTheMapThatItWroteWhenItWasStopped) {
  hearer_ = std::make_shared<MapHearer>(config_, listener_);
  Begin();
  for (int k = 0; k < 60; ++k) Tick(true);
  Tick(false, true);
  const std::string mesh = config_.launch.out + "/mesh.ply", before = config_.launch.out + "/before.ply";
  std::filesystem::rename(mesh, before);
  const std::int64_t version = hearer_->map_version();
  Begin();
  for (int k = 0; k < 200; ++k) Tick(false);
  EXPECT_GE(hearer_->map_version(), version);
  EXPECT_EQ(hearer_->map_version(), own_hearer_->map_version());
  EXPECT_EQ(hearer_->map().Digest(), own_hearer_->map().Digest()) << "what was heard before gives way";
  Tick(false, true);
  EXPECT_TRUE(ReadPly(mesh).vertices_W == ReadPly(before).vertices_W);
}

TEST_F(MapFusion, IsRefusedASavedMapOfAnotherGrid) {
  Begin();
  for (int k = 0; k < 20; ++k) Tick(true);
  Tick(false, true);
  std::filesystem::rename(config_.launch.out + "/map.tsdf", config_.launch.out + "/other.tsdf");
  config_.map.start = config_.launch.out + "/other.tsdf";
  config_.map.voxel_m = 0.2;
  EXPECT_THROW(Begin(), ConfigError);
}

TEST_F(MapFusion, RefusesASummaryOfAnotherGridAndLives) {
  hearer_ = std::make_shared<MapHearer>(config_, listener_);
  Tick(false);
  MapSummary other;
  other.grid = VoxelGrid(0.5, config_.volume_W(), 1);
  other.truncation_m = 1;
  other.weight_max = 1;
  uavs_.Publish(channels::kMapSummary, Encode(other));
  Tick(false);
  Tick(false);
  EXPECT_EQ(listener_.counts().bad, 1);
}

TEST_F(MapFusion, WritesMeshAndOctreeWhenTheMissionIsOver) {
  Begin();
  for (int k = 0; k < 30; ++k) Tick(true);
  Tick(false, true);
  EXPECT_EQ(health_.last_error(), "");
  const TriMesh mesh = ReadPly(config_.launch.out + "/mesh.ply");
  ASSERT_GT(mesh.triangles.size(), 1000u);
  int far = 0;
  for (const Eigen::Vector3f& p : mesh.vertices_W) far += std::abs(scene_.Distance(p.cast<double>())) > 0.125;
  EXPECT_LT(far, 0.02 * mesh.vertices_W.size());  // at the limbs of the box
  EXPECT_GT(std::filesystem::file_size(config_.launch.out + "/map.bt"), 1000u);
  EXPECT_FALSE(health_.TakeSamples()["integration_ms"].empty());
}

}  // namespace
}  // namespace citrine

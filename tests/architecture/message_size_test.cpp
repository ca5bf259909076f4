#include <gtest/gtest.h>

#include "core/random.h"
#include "modules/channels.h"
#include "modules/codec/fleet_assignment.h"
#include "modules/codec/lidar_scan.h"
#include "modules/codec/map_blocks.h"
#include "modules/codec/mission_config_text.h"
#include "modules/codec/module_health.h"
#include "modules/codec/octree.h"
#include "modules/codec/path.h"
#include "modules/codec/point_cloud.h"
#include "modules/codec/step_done.h"
#include "modules/codec/trajectory.h"

namespace citrine {
namespace {

// What a mission may hold at the most: the limits of the configuration, and generous ones where it has none.
constexpr int kUavs = 15;
constexpr int kWaypoints = 500;
constexpr int kSegments = 200;
constexpr int kMissionFile_bytes = 40'000;
constexpr int kBulk_bytes = 33'000;

template <class Message>
int Size(const Message& message) {
  return message.getEncodedSize();
}
constexpr int kLimit = static_cast<int>(Bus::kMaxMessageBytes);

TEST(MessageSize, StaysWithinTheLimitForBulk) {
  MapBlock noise;
  Random random(4);
  for (auto& code : noise.distance) code = static_cast<std::uint8_t>(random.Next());
  std::vector<MapBlock> blocks(kMaxBlocksAMessage, noise);
  for (MapBlock& block : blocks)
    for (auto& code : block.weight) code = static_cast<std::uint8_t>(random.Next());
  EXPECT_LE(Size(Encode(blocks)), kBulk_bytes);
  for (const auto& message : EncodeInMessages(OctreeBytes{1, 0.25, std::vector<std::uint8_t>(1 << 20)}))
    EXPECT_LE(Size(message), kBulk_bytes);
  PointCloud cloud;
  cloud.points_S.resize(100'000, Eigen::Vector3f::Zero());
  for (const auto& message : EncodeInMessages(cloud)) EXPECT_LE(Size(message), kBulk_bytes);
}

TEST(MessageSize, StaysWithinTheLimitForScansThatDoNotPack) {
  LidarScan scan;
  Random random(5);
  for (std::size_t i = 0; i < scan.model.num_beams(); ++i)
    scan.ranges_m.push_back(static_cast<float>(random.Uniform(0.5, 10)));
  EXPECT_LE(Size(Encode(scan)), kLimit);
}

TEST(MessageSize, StaysWithinTheLimitForPlansAndFleets) {
  EXPECT_LE(Size(Encode(Path{1, std::vector<Waypoint>(kWaypoints), 0, true, {}})), kLimit);
  EXPECT_LE(Size(Encode(Trajectory{1, 1, 0, std::vector<TrajectorySegment>(kSegments)})), kLimit);
  EXPECT_LE(Size(Encode(FleetAssignment{1, 1, 0, 2, std::vector<Eigen::Vector3d>(kUavs)})), kLimit);
  StepDone done{1, "uav_dynamics", 0, {}};
  for (int uav = 1; uav <= kUavs; ++uav) done.last_seq[channels::kLidarScan.Of(uav)] = uav;
  EXPECT_LE(Size(Encode(done)), kLimit);
}

TEST(MessageSize, StaysWithinTheLimitForWhatIsSaidOfAMission) {
  const MissionConfigText text{
      "id", std::string(kMissionFile_bytes, 'x'), std::vector<std::string>(50, "mission.seed=1"), {}, {}};
  EXPECT_LE(Size(Encode(text)), kLimit);
  ModuleHealth health;
  health.samples["integration_ms"].resize(8000);  // a heartbeat's share of samples
  EXPECT_LE(Size(Encode(health)), kLimit);
}

}  // namespace
}  // namespace citrine

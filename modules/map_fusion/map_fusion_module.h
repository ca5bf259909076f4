#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/map/occupancy_tree.h"
#include "core/quality/mission_progress.h"
#include "fusion/block_rotation.h"
#include "fusion/map_fuser.h"
#include "modules/channels.h"
#include "modules/map_fusion/cloud_chunks.h"
#include "modules/map_fusion/fleet_positions.h"
#include "modules/map_hearer.h"
#include "modules/runtime/module.h"

namespace citrine {

/// The base station. Hears UAV*_LIDAR_SCAN and UAV*_POINT_CLOUD (and where the UAVs are); says MAP_BLOCKS,
/// MAP_SUMMARY, MAP_OCTREE and MISSION_PROGRESS; writes mesh.ply, map.bt and map.tsdf when the mission is
/// over, or it is told to end; started again in the same mission, it goes on from the latter.
class MapFusionModule : public Module {
 public:
  static constexpr const char* kName = "map_fusion";
  static constexpr const char* kSummary = "fuses the scans of all UAVs into one map and says what changed";
  static constexpr bool kHearsMap = true;
  static constexpr bool kPerUav = false;

  /// @throws ConfigError if the map cannot be built from the configuration
  explicit MapFusionModule(const ModuleContext& context);

  void Tick(const Step& step) override;

 private:
  void GoOnFromSavedMap();
  void HearFleet();
  /// Scans and clouds that have come, with the UAV that took each, in the order in which they were taken.
  std::vector<std::pair<int, LidarScan>> TakeScans();
  void IntegrateScans();
  /// Those to be said next, as they are now: that changed, then the rest in rotation.
  std::vector<MapBlock> NextBlocks();
  void SayQueued();
  MissionProgress Progress();
  void QueueOctree();
  void WriteResults();
  bool NobodyHasAViewLeft() const;

  const MissionConfig config_;
  Bus& bus_;
  Health& health_;
  std::shared_ptr<MapHearer> hearer_;

  fusion::MapFuser fuser_;
  fusion::BlockRotation rotation_;
  OccupancyTree octree_;
  FleetPositions positions_;
  CloudChunks chunks_;
  std::vector<bool> no_view_left_;  ///< by UAV id - 1

  std::shared_ptr<Inbox<citrine_lcm::uav_state_t>> states_;
  std::shared_ptr<Inbox<citrine_lcm::lidar_scan_t>> scans_;
  std::shared_ptr<Inbox<citrine_lcm::point_cloud_t>> clouds_;
  std::shared_ptr<Inbox<citrine_lcm::fleet_status_t>> fleet_statuses_;

  Every publish_, progress_;
  std::optional<Every> say_octree_;
  std::deque<citrine_lcm::map_blocks_t> blocks_to_say_;
  std::deque<citrine_lcm::octree_t> octree_to_say_;
  std::optional<MissionProgress> progress_to_say_;
  std::optional<citrine_lcm::map_summary_t>
      summary_to_say_;  ///< of the map when `blocks_to_say_` have been said
};

}  // namespace citrine

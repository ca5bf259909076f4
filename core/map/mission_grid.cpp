#include "core/map/mission_grid.h"

namespace citrine {

VoxelGrid MissionGrid(const MissionConfig& config) {
  return VoxelGrid(config.map.voxel_m, config.volume_W(), config.map.truncation_m + config.map.voxel_m);
}

Quantisation MissionQuantisation(const MissionConfig& config) {
  return Quantisation(config.map.truncation_m, config.quality_goals().w_star_max());
}

PlanningMap MissionPlanningMap(const MissionConfig& config) {
  PlanningMap map(MissionGrid(config), MissionQuantisation(config));
  for (const Eigen::Vector3d& spawn_W : config.mission.spawns_m) map.AssumeFree({spawn_W, kStartBall_m});
  return map;
}

}  // namespace citrine

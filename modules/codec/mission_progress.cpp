#include "modules/codec/mission_progress.h"

#include "modules/codec/bad_message.h"

namespace citrine {

citrine_lcm::mission_progress_t Encode(const MissionProgress& progress) {
  citrine_lcm::mission_progress_t message{};
  message.map_version = progress.map_version;
  message.surface_voxels = progress.surface_voxels;
  message.voxels_at_goal = progress.voxels_at_goal;
  message.elements_ise = progress.elements_ise;
  message.elements_lqse = progress.elements_lqse;
  message.z_bar_sat = progress.z_bar_sat;
  message.z_sat = progress.z_sat;
  message.z_goal = progress.z_goal;
  message.known_pct = progress.known_pct;
  return message;
}

MissionProgress Decode(const citrine_lcm::mission_progress_t& message) {
  Require(message.map_version >= 0 && message.elements_ise >= 0 && message.elements_lqse >= 0,
          "mission_progress_t: a count < 0");
  Require(message.voxels_at_goal >= 0 && message.voxels_at_goal <= message.surface_voxels,
          "mission_progress_t: voxels_at_goal exceeds surface_voxels");
  RequireFinite("mission_progress_t: a share is not a number", message.z_bar_sat, message.z_sat,
                message.z_goal, message.known_pct);
  MissionProgress progress;
  progress.map_version = message.map_version;
  progress.surface_voxels = message.surface_voxels;
  progress.voxels_at_goal = message.voxels_at_goal;
  progress.elements_ise = message.elements_ise;
  progress.elements_lqse = message.elements_lqse;
  progress.z_bar_sat = message.z_bar_sat;
  progress.z_sat = message.z_sat;
  progress.z_goal = message.z_goal;
  progress.known_pct = message.known_pct;
  return progress;
}

}  // namespace citrine

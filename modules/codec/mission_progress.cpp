#include "modules/codec/mission_progress.h"

#include "modules/codec/bad_message.h"

namespace citrine {
namespace {

void RequireCounts(std::int32_t surface_voxels, std::int32_t voxels_at_goal, std::int32_t elements_ise) {
  Require(elements_ise >= 0, "mission_progress_t: a count < 0");
  Require(voxels_at_goal >= 0 && voxels_at_goal <= surface_voxels,
          "mission_progress_t: voxels_at_goal exceeds surface_voxels");
}

}  // namespace

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
  message.num_parts = static_cast<std::int32_t>(progress.parts.size());
  for (const MissionProgress::Part& part : progress.parts) {
    message.part_surface_voxels.push_back(part.surface_voxels);
    message.part_voxels_at_goal.push_back(part.voxels_at_goal);
    message.part_elements_ise.push_back(part.elements_ise);
    message.part_z_bar_sat.push_back(part.z_bar_sat);
    message.part_z_sat.push_back(part.z_sat);
    message.part_z_goal.push_back(part.z_goal);
  }
  return message;
}

MissionProgress Decode(const citrine_lcm::mission_progress_t& message) {
  Require(message.map_version >= 0 && message.elements_lqse >= 0, "mission_progress_t: a count < 0");
  RequireCounts(message.surface_voxels, message.voxels_at_goal, message.elements_ise);
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
  for (std::int32_t i = 0; i < message.num_parts; ++i) {
    RequireCounts(message.part_surface_voxels[i], message.part_voxels_at_goal[i],
                  message.part_elements_ise[i]);
    RequireFinite("mission_progress_t: a part's share is not a number", message.part_z_bar_sat[i],
                  message.part_z_sat[i], message.part_z_goal[i]);
    progress.parts.push_back({message.part_surface_voxels[i], message.part_voxels_at_goal[i],
                              message.part_elements_ise[i], message.part_z_bar_sat[i], message.part_z_sat[i],
                              message.part_z_goal[i]});
  }
  return progress;
}

}  // namespace citrine

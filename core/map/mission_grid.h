#pragma once

#include "core/config/mission_config.h"
#include "core/map/planning_map.h"

namespace citrine {

/// Grid and codes of a mission's map, and an empty planning map on them with its start balls: the base
/// station and every hearer build them from the same configuration, and so agree.
VoxelGrid MissionGrid(const MissionConfig& config);
Quantisation MissionQuantisation(const MissionConfig& config);
PlanningMap MissionPlanningMap(const MissionConfig& config);

inline constexpr double kStartBall_m = 2.25;  ///< true free space around a spawn (design, section 6)

}  // namespace citrine

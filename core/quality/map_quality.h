#pragma once

#include <cstdint>
#include <vector>

#include "core/map/planning_map.h"
#include "core/quality/active_surface.h"
#include "core/quality/mission_progress.h"

namespace citrine {

/// The quality of a map, or of a part of it, over its observed surface voxels M_S (eqs. 2-4).
struct MapQuality {
  std::int32_t surface_voxels = 0;  ///< |M_S|
  std::int32_t voxels_at_goal = 0;  ///< of them, those with w >= w*
  std::int32_t elements_ise = 0;
  double z_bar = 0;  ///< mean weight over M_S, as carried by the quantised map (clipped at the largest w*)
  double z_bar_sat = 0;  ///< mean of min(w, w*)
  double z_goal = 0;     ///< Z*: mean of w*
  double xi = 0;         ///< 0 while an incomplete element remains that could be scanned, else 1
  double z() const { return xi * z_bar; }          ///< eq. (2)
  double z_sat() const { return xi * z_bar_sat; }  ///< eq. (3); equals z_goal iff no element is active
};

/// Of the whole, and of each part in the order of QualityGoals::PartOf.
struct MapQualities {
  MapQuality whole;
  std::vector<MapQuality> parts;
};

/// @param all_remaining_out_of_reach  whether every ISE left belongs to ISE_rem (definition 2), that is, no
/// UAV has a
///        view left; without ISE xi is 1 regardless
MapQualities QualityOf(const PlanningMap& map, const ActiveSurface& surface, bool all_remaining_out_of_reach);

/// What the base station says of it.
MissionProgress ProgressOf(const PlanningMap& map, const ActiveSurface& surface,
                           bool all_remaining_out_of_reach, std::int64_t map_version);

}  // namespace citrine

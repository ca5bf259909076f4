#pragma once

#include <cstdint>
#include <vector>

namespace citrine {

/// How far the map is, as the base station says it; computed on the quantised map inside the mission volume.
struct MissionProgress {
  std::int64_t map_version = 0;
  std::int32_t surface_voxels = 0;  ///< |M_S|
  std::int32_t voxels_at_goal = 0;  ///< of them, those with w >= w*
  std::int32_t elements_ise = 0;
  std::int32_t elements_lqse = 0;
  double z_bar_sat = 0;  ///< mean of min(w, w*) over M_S (eq. 3)
  double z_sat = 0;      ///< xi z_bar_sat (eq. 3)
  double z_goal = 0;     ///< mean of w* over M_S: Z* (eq. 4)
  double known_pct = 0;  ///< of the mission volume

  /// The same of a part of the volume.
  struct Part {
    std::int32_t surface_voxels = 0, voxels_at_goal = 0, elements_ise = 0;
    double z_bar_sat = 0, z_sat = 0, z_goal = 0;
  };
  /// Where the mission has quality regions: what lies in none of them, then each; else empty.
  std::vector<Part> parts;
};

}  // namespace citrine

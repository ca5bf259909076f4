#include "core/quality/map_quality.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace citrine {

namespace {

/// The sums of eqs. (2) and (3) before they are divided by |M_S|.
struct Sums {
  double w = 0, w_sat = 0, w_star = 0;
  std::int32_t voxels = 0, at_goal = 0, ise = 0;

  void operator+=(const Sums& other) {
    w += other.w, w_sat += other.w_sat, w_star += other.w_star;
    voxels += other.voxels, at_goal += other.at_goal, ise += other.ise;
  }
  MapQuality Mean(bool all_remaining_out_of_reach) const {
    MapQuality quality{voxels, at_goal, ise};
    quality.xi = ise == 0 || all_remaining_out_of_reach ? 1 : 0;
    if (voxels == 0) return quality;
    quality.z_bar = w / voxels;
    quality.z_bar_sat = w_sat / voxels;
    quality.z_goal = w_star / voxels;
    return quality;
  }
};

}  // namespace

MapQualities QualityOf(const PlanningMap& map, const ActiveSurface& surface,
                       bool all_remaining_out_of_reach) {
  const VoxelGrid& grid = surface.grid();
  const QualityGoals& goals = surface.goals();
  std::vector<Sums> parts(goals.regions().size() + 1);
  const std::vector<std::uint8_t>& classes = surface.classes();
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (std::uint64_t eight; i % kBlockSide == 0 && i + kBlockSide <= classes.size()) {
      std::memcpy(&eight, &classes[i], sizeof eight);
      if (eight == 0) {
        i += kBlockSide - 1;
        continue;
      }
    }
    const SurfaceClass c = surface.At(i);
    if (c != SurfaceClass::kReached && c != SurfaceClass::kLqse && c != SurfaceClass::kIse) continue;
    const std::size_t part = goals.regions().empty() ? 0 : goals.PartOf(grid.Centre(grid.FromLinear(i)));
    if (c == SurfaceClass::kIse) {
      ++parts[part].ise;
      continue;
    }
    const double w_star = goals.OfPart(part).w_star, w = map.weight(i);
    const bool reached = c == SurfaceClass::kReached;
    parts[part] += {w, reached ? w_star : std::min(w, w_star), w_star, 1, reached, 0};
  }
  Sums whole;
  MapQualities qualities;
  for (const Sums& part : parts) {
    whole += part;
    qualities.parts.push_back(part.Mean(all_remaining_out_of_reach));
  }
  qualities.whole = whole.Mean(all_remaining_out_of_reach);
  return qualities;
}

MissionProgress ProgressOf(const PlanningMap& map, const ActiveSurface& surface,
                           bool all_remaining_out_of_reach, std::int64_t map_version) {
  const MapQualities qualities = QualityOf(map, surface, all_remaining_out_of_reach);
  const MapQuality& whole = qualities.whole;
  MissionProgress progress;
  progress.map_version = map_version;
  progress.surface_voxels = whole.surface_voxels;
  progress.voxels_at_goal = whole.voxels_at_goal;
  progress.elements_ise = whole.elements_ise;
  progress.elements_lqse = whole.surface_voxels - whole.voxels_at_goal;
  progress.z_bar_sat = whole.z_bar_sat;
  progress.z_sat = whole.z_sat();
  progress.z_goal = whole.z_goal;
  if (qualities.parts.size() > 1)
    for (const MapQuality& part : qualities.parts)
      progress.parts.push_back({part.surface_voxels, part.voxels_at_goal, part.elements_ise, part.z_bar_sat,
                                part.z_sat(), part.z_goal});

  const VoxelGrid& grid = map.grid();
  const Eigen::Vector3i inner = grid.inside_max() - grid.inside_min();
  std::int64_t unknown = 0;
  for (int z = grid.inside_min().z(); z < grid.inside_max().z(); ++z)
    for (int y = grid.inside_min().y(); y < grid.inside_max().y(); ++y) {
      const std::uint8_t* row = &map.states()[grid.Linear({grid.inside_min().x(), y, z})];
      unknown += std::count(row, row + inner.x(), std::uint8_t{0});
    }
  const double total = static_cast<double>(inner.x()) * inner.y() * inner.z();
  progress.known_pct = 100.0 * (1.0 - static_cast<double>(unknown) / total);
  return progress;
}

}  // namespace citrine

#include "core/quality/map_quality.h"

#include <algorithm>

namespace citrine {

MapQuality QualityOf(const PlanningMap& map, const ActiveSurface& surface, bool all_remaining_out_of_reach) {
  MapQuality quality;
  const VoxelGrid& grid = surface.grid();
  double sum = 0, sum_sat = 0, sum_goal = 0;
  std::int64_t voxels = 0;
  for (std::size_t i = 0; i < surface.classes().size(); ++i) {
    const SurfaceClass c = surface.At(i);
    if (c != SurfaceClass::kReached && c != SurfaceClass::kLqse) continue;
    const double w_star = surface.goals().At(grid.Centre(grid.FromLinear(i))).w_star;
    const double w = map.weight(i);
    sum += w;
    sum_sat += c == SurfaceClass::kReached ? w_star : std::min(w, w_star);
    sum_goal += w_star;
    ++voxels;
  }
  if (voxels > 0) {
    quality.z_bar = sum / voxels;
    quality.z_bar_sat = sum_sat / voxels;
    quality.z_goal = sum_goal / voxels;
  }
  quality.xi = surface.Count(SurfaceClass::kIse) == 0 || all_remaining_out_of_reach ? 1 : 0;
  return quality;
}

MissionProgress ProgressOf(const PlanningMap& map, const ActiveSurface& surface,
                           bool all_remaining_out_of_reach, std::int64_t map_version) {
  const MapQuality quality = QualityOf(map, surface, all_remaining_out_of_reach);
  MissionProgress progress;
  progress.map_version = map_version;
  progress.voxels_at_goal = surface.Count(SurfaceClass::kReached);
  progress.elements_ise = surface.Count(SurfaceClass::kIse);
  progress.elements_lqse = surface.Count(SurfaceClass::kLqse);
  progress.surface_voxels = progress.voxels_at_goal + progress.elements_lqse;
  progress.z_bar_sat = quality.z_bar_sat;
  progress.z_sat = quality.z_sat();
  progress.z_goal = quality.z_goal;

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

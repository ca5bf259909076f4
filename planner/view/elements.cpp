#include "planner/view/elements.h"

#include "planner/view/surface_normal.h"

namespace citrine::planner {

std::vector<Element> ListElements(const PlanningMap& map, const ActiveSurface& surface,
                                  const std::function<bool(std::uint32_t linear)>& skip) {
  const VoxelGrid& grid = map.grid();
  const SurfaceNormal whole(map, surface.goals().whole().w_star);
  std::vector<SurfaceNormal> of_region;
  for (const QualityGoals::Region& region : surface.goals().regions())
    of_region.emplace_back(map, region.goal.w_star);

  std::vector<Element> elements;
  elements.reserve(surface.elements().size());
  for (const std::uint32_t linear : surface.elements()) {
    if (skip(linear)) continue;
    Element e;
    e.linear = linear;
    e.kind = surface.At(linear);
    e.voxel = grid.FromLinear(linear);
    e.p_W = grid.Centre(e.voxel);
    e.weight = map.weight(linear);
    e.d_star_m = surface.goals().whole().d_star_m;
    const SurfaceNormal* normal = &whole;
    for (std::size_t i = 0; i < of_region.size(); ++i) {
      if (!surface.goals().regions()[i].box_W.contains(e.p_W)) continue;
      normal = &of_region[i];
      e.d_star_m = surface.goals().regions()[i].goal.d_star_m;
      break;
    }
    e.normal_W = normal->At(e.voxel);
    elements.push_back(e);
  }
  return elements;
}

}  // namespace citrine::planner

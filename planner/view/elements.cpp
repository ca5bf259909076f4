#include "planner/view/elements.h"

#include "core/parallel_for.h"
#include "planner/view/surface_normal.h"

namespace citrine::planner {

namespace {
constexpr int kParts = 8;  ///< that threads take
}  // namespace

std::vector<Element> ListElements(const PlanningMap& map, const ActiveSurface& surface,
                                  const std::function<bool(std::uint32_t linear)>& skip) {
  const VoxelGrid& grid = map.grid();
  const SurfaceNormal whole(map, surface.goals().whole().w_star);
  std::vector<SurfaceNormal> of_region;
  for (const QualityGoals::Region& region : surface.goals().regions())
    of_region.emplace_back(map, region.goal.w_star);

  std::vector<std::uint32_t> voxels;
  voxels.reserve(surface.elements().size());
  for (const std::uint32_t linear : surface.elements())
    if (!skip(linear)) voxels.push_back(linear);

  std::vector<Element> elements(voxels.size());
  ParallelForEach(voxels.size(), kParts, [&](std::size_t k) {
    Element& e = elements[k];
    e.linear = voxels[k];
    e.kind = surface.At(e.linear);
    e.voxel = grid.FromLinear(e.linear);
    e.p_W = grid.Centre(e.voxel);
    e.weight = map.weight(e.linear);
    e.d_star_m = surface.goals().whole().d_star_m;
    const SurfaceNormal* normal = &whole;
    for (std::size_t i = 0; i < of_region.size(); ++i) {
      if (!surface.goals().regions()[i].box_W.contains(e.p_W)) continue;
      normal = &of_region[i];
      e.d_star_m = surface.goals().regions()[i].goal.d_star_m;
      break;
    }
    e.normal_W = normal->At(e.voxel);
  });
  return elements;
}

}  // namespace citrine::planner

#include "viz/relief.h"

#include <algorithm>
#include <cmath>

namespace citrine::viz {

namespace {

constexpr double kSunAltitude_rad = 0.75;
constexpr double kSunAzimuth_rad = 2.36;  // north-west
constexpr double kExaggeration = 1.0;
constexpr int kShadowReach_cells = 32;

/// The highest place where the map passes from free to solid, walking down; the surface is where the distance
/// is zero.
void LookDown(const Scene& scene, int vx, int vy, int top_z, Relief& relief, std::size_t cell) {
  const PlanningMap& map = *scene.map;
  const VoxelGrid& grid = map.grid();
  for (int z = top_z; z >= 0; --z) {
    const std::size_t i = grid.Linear({vx, vy, z});
    if (map.state(i) == VoxelState::kUnknown) continue;
    relief.seen[cell] = Relief::Seen::kFree;
    const double distance_m = map.distance_m(i);
    if (distance_m >= grid.voxel_m() / 2) continue;
    const Eigen::Vector3d p_W = grid.Centre({vx, vy, z});
    double weight = map.weight(i);
    if (z > 0) weight = std::max(weight, map.weight(i - grid.stride_z()));
    if (z + 1 < grid.voxels().z()) weight = std::max(weight, map.weight(i + grid.stride_z()));
    relief.seen[cell] = Relief::Seen::kSurface;
    relief.top_m[cell] = static_cast<float>(p_W.z() - std::max(distance_m, -grid.voxel_m() / 2));
    relief.share[cell] = static_cast<float>(std::min(weight / scene.goals.At(p_W).w_star, 1.0));
    return;
  }
}

/// Where nothing is known of a neighbour the surface counts as level.
float TopOr(const Relief& relief, int x, int y, float otherwise) {
  if (x < 0 || y < 0 || x >= relief.width || y >= relief.height) return otherwise;
  const std::size_t cell = relief.Cell(x, y);
  return relief.seen[cell] == Relief::Seen::kSurface ? relief.top_m[cell] : otherwise;
}

double HillShade(const Relief& relief, int x, int y) {
  const float here = relief.top_m[relief.Cell(x, y)];
  const double east = (TopOr(relief, x + 1, y, here) - TopOr(relief, x - 1, y, here)) / (2 * relief.cell_m);
  const double north = (TopOr(relief, x, y - 1, here) - TopOr(relief, x, y + 1, here)) / (2 * relief.cell_m);
  const Eigen::Vector3d normal =
      Eigen::Vector3d(-kExaggeration * east, -kExaggeration * north, 1).normalized();
  const Eigen::Vector3d sun(std::cos(kSunAltitude_rad) * std::cos(kSunAzimuth_rad),
                            std::cos(kSunAltitude_rad) * std::sin(kSunAzimuth_rad),
                            std::sin(kSunAltitude_rad));
  return std::max(0.0, normal.dot(sun));
}

/// How much of the sun higher ground towards it leaves, with a soft edge of half a metre.
double SunLeft(const Relief& relief, int x, int y) {
  const float here = relief.top_m[relief.Cell(x, y)];
  double highest_over_ray_m = 0;
  for (int k = 1; k <= kShadowReach_cells; ++k) {
    const int sx = x + static_cast<int>(std::lround(k * std::cos(kSunAzimuth_rad)));
    const int sy = y - static_cast<int>(std::lround(k * std::sin(kSunAzimuth_rad)));
    const double ray_m = here + k * relief.cell_m * std::tan(kSunAltitude_rad);
    highest_over_ray_m = std::max(highest_over_ray_m, TopOr(relief, sx, sy, here) - ray_m);
  }
  return 1 - std::min(highest_over_ray_m / 0.5, 1.0);
}

void Light(Relief& relief) {
  for (int y = 0; y < relief.height; ++y) {
    for (int x = 0; x < relief.width; ++x) {
      const std::size_t cell = relief.Cell(x, y);
      if (relief.seen[cell] != Relief::Seen::kSurface) continue;
      const double flat = std::sin(kSunAltitude_rad);
      const double sun = HillShade(relief, x, y) / flat * (0.25 + 0.75 * SunLeft(relief, x, y));
      relief.light[cell] = static_cast<float>(0.32 + 0.68 * (sun > 1 ? 1 + 0.35 * (sun - 1) : sun));
    }
  }
}

}  // namespace

Relief ReliefOf(const Scene& scene) {
  Relief relief;
  if (scene.map == nullptr) return relief;
  const VoxelGrid& grid = scene.map->grid();
  const VoxelIndex& min = grid.inside_min();
  const VoxelIndex& max = grid.inside_max();
  relief.width = max.x() - min.x();
  relief.height = max.y() - min.y();
  relief.cell_m = grid.voxel_m();
  relief.corner_W = (grid.Centre(min).array() - grid.voxel_m() / 2).head<2>();
  const std::size_t cells = static_cast<std::size_t>(relief.width) * relief.height;
  relief.seen.assign(cells, Relief::Seen::kNothing);
  relief.top_m.assign(cells, 0);
  relief.share.assign(cells, 0);
  relief.light.assign(cells, 0);

  const double ceiling_m = std::min(scene.ceiling_m, grid.Centre(max).z());
  const int top_z = std::clamp(grid.IndexOf({0, 0, ceiling_m}).z(), 0, max.z()) - 1;
  relief.lowest_m = std::numeric_limits<float>::max();
  relief.highest_m = std::numeric_limits<float>::lowest();
  for (int y = 0; y < relief.height; ++y) {
    for (int x = 0; x < relief.width; ++x) {
      const std::size_t cell = relief.Cell(x, y);
      LookDown(scene, min.x() + x, max.y() - 1 - y, top_z, relief, cell);
      if (relief.seen[cell] != Relief::Seen::kSurface) continue;
      relief.lowest_m = std::min(relief.lowest_m, relief.top_m[cell]);
      relief.highest_m = std::max(relief.highest_m, relief.top_m[cell]);
    }
  }
  Light(relief);
  return relief;
}

}  // namespace citrine::viz

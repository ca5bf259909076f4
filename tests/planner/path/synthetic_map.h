#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

#include "core/map/planning_map.h"
#include "core/random.h"

namespace citrine::planner {

/// [m] signed distance to the nearest surface, negative inside; and whether a point has been seen.
using DistanceTo = std::function<double(const Eigen::Vector3d&)>;
using IsKnown = std::function<bool(const Eigen::Vector3d&)>;

inline bool Everywhere(const Eigen::Vector3d&) { return true; }
inline double EmptySpace(const Eigen::Vector3d&) { return 100; }

inline VoxelGrid GridOf(const Eigen::Vector3d& size_m) {
  return {0.25, Eigen::AlignedBox3d(Eigen::Vector3d::Zero(), size_m), 0.75};
}

/// Writes an analytic scene into a planning map as the base station would say it.
inline void Write(const DistanceTo& distance, const IsKnown& known, std::uint32_t version, PlanningMap* map) {
  const VoxelGrid& grid = map->grid();
  for (int block = 0; block < grid.num_blocks(); ++block) {
    MapBlock said;
    said.index = block;
    said.version = version;
    const VoxelIndex origin = grid.BlockOrigin(block);
    for (int z = 0; z < kBlockSide; ++z)
      for (int y = 0; y < kBlockSide; ++y)
        for (int x = 0; x < kBlockSide; ++x) {
          const VoxelIndex v = origin + VoxelIndex(x, y, z);
          const Eigen::Vector3d p_W = grid.Centre(v);
          if (!known(p_W)) continue;
          said.distance[static_cast<std::size_t>(VoxelGrid::InBlock(v))] =
              map->quantisation().DistanceCode(distance(p_W));
        }
    map->Apply(said);
  }
  map->Update();
}

inline PlanningMap MapOf(const Eigen::Vector3d& size_m, const DistanceTo& distance,
                         const IsKnown& known = Everywhere) {
  PlanningMap map(GridOf(size_m), Quantisation(0.5, 1 / (4.5 * 4.5)));
  Write(distance, known, 1, &map);
  return map;
}

struct Cylinder {
  double x, y, radius_m;
};

/// Vertical cylinders; no two touch, and none stands within 2.2 m of the two ends.
inline std::vector<Cylinder> Forest(std::uint64_t seed, double size_m, int trees,
                                    const Eigen::Vector3d& start_W, const Eigen::Vector3d& goal_W) {
  Random random(seed);
  std::vector<Cylinder> forest;
  for (int i = 0; i < trees; ++i) {
    const Cylinder tree{random.Uniform(0, size_m), random.Uniform(0, size_m), random.Uniform(0.2, 0.6)};
    const Eigen::Vector2d at(tree.x, tree.y);
    if ((at - start_W.head<2>()).norm() > 2.2 + tree.radius_m &&
        (at - goal_W.head<2>()).norm() > 2.2 + tree.radius_m)
      forest.push_back(tree);
  }
  return forest;
}

inline DistanceTo DistanceToForest(std::vector<Cylinder> forest) {
  return [forest = std::move(forest)](const Eigen::Vector3d& p) {
    double least = 100;
    for (const Cylinder& tree : forest)
      least = std::min(least, std::hypot(p.x() - tree.x, p.y() - tree.y) - tree.radius_m);
    return least;
  };
}

/// A wall 0.5 m thick at x = 10 with one opening in y.
inline DistanceTo WallWithGap(double y_from, double y_to) {
  return [=](const Eigen::Vector3d& p) {
    const double out_x = std::abs(p.x() - 10) - 0.25;
    const double in_gap = std::min(p.y() - y_from, y_to - p.y());  // how far inside the opening
    if (in_gap <= 0) return std::max(out_x, in_gap);
    return std::hypot(std::max(out_x, 0.0), in_gap);
  };
}

}  // namespace citrine::planner

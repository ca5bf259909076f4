#pragma once

#include <Eigen/Geometry>

#include "core/geometry/pose.h"
#include "core/map/tsdf_map.h"

namespace citrine::fusion {

inline constexpr double kVoxel_m = 0.25, kTruncation_m = 0.5;

inline VoxelGrid Grid(const Eigen::Vector3d& min_W = {-12, -12, 0},
                      const Eigen::Vector3d& max_W = {12, 12, 8}) {
  return VoxelGrid(kVoxel_m, {min_W, max_W}, kTruncation_m + kVoxel_m);
}

/// @param roll,pitch,yaw  [rad]
inline Pose At(double x, double y, double z, double roll = 0, double pitch = 0, double yaw = 0) {
  return {{x, y, z},
          Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
              Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
              Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX())};
}

/// What a map holds of a voxel; all 0 where nothing is known.
struct Voxel {
  double distance_m, weight, quality;
  bool known() const { return weight > 0; }
};

inline Voxel At(const TsdfMap& map, const VoxelIndex& voxel) {
  const TsdfBlock* block = map.Find(map.grid().Block(voxel));
  const int i = TsdfBlock::IndexOf(voxel);
  if (!block) return {0, 0, 0};
  return {block->distance_m[i], block->weight[i], block->quality[i]};
}
inline Voxel At(const TsdfMap& map, const Eigen::Vector3d& p_W) { return At(map, map.grid().IndexOf(p_W)); }

template <class Visit>
void ForEachVoxel(const VoxelGrid& grid, Visit&& visit) {
  for (std::size_t i = 0; i < grid.num_voxels(); ++i) visit(grid.FromLinear(i));
}

}  // namespace citrine::fusion

#include "core/grid/grid_around.h"

namespace citrine {

VoxelGrid GridAround(double voxel_m, const Eigen::AlignedBox3d& box_W) {
  const double block_m = kBlockSide * voxel_m;
  const Eigen::Vector3d first = (box_W.min() / block_m).array().floor();
  const Eigen::Vector3d end = (box_W.max() / block_m).array().ceil().max(first.array() + 1);
  return VoxelGrid(voxel_m, {first * block_m, end * block_m}, 0);
}

}  // namespace citrine

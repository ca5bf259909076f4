#include "core/grid/voxel_grid.h"

#include <stdexcept>

namespace citrine {

VoxelGrid::VoxelGrid(double voxel_m, const Eigen::AlignedBox3d& volume_W, double margin_m)
    : voxel_m_(voxel_m), inv_voxel_m_(1.0 / voxel_m), volume_W_(volume_W) {
  if (!(voxel_m > 0) || volume_W.isEmpty()) throw std::invalid_argument("a voxel grid needs a volume");
  // The volume's lower corner lies on a voxel corner, so that a ground at the lower face is cut cleanly.
  const int margin = static_cast<int>(std::ceil(margin_m * inv_voxel_m_ - 1e-9));
  const Eigen::Vector3i inner =
      (volume_W.sizes() * inv_voxel_m_).unaryExpr([](double x) { return std::ceil(x - 1e-6); }).cast<int>();
  origin_W_ = volume_W.min() - Eigen::Vector3d::Constant(margin * voxel_m);
  blocks_ = (inner.array() + 2 * margin + kBlockSide - 1) / kBlockSide;
  voxels_ = blocks_ * kBlockSide;
  inside_min_ = Eigen::Vector3i::Constant(margin);
  inside_max_ = inside_min_ + inner;
}

}  // namespace citrine

#pragma once

#include "core/grid/voxel_grid.h"

namespace citrine {

/// A grid of whole blocks around a box, which stand where those of any other such grid do; all of it is
/// inside.
VoxelGrid GridAround(double voxel_m, const Eigen::AlignedBox3d& box_W);

}  // namespace citrine

#pragma once

#include <vector>

#include "core/grid/voxel_grid.h"

namespace citrine {

/// Voxels [min, max).
struct DirtyBox {
  VoxelIndex min, max;
};

/// Few boxes that hold all the blocks; cut where a gap of `gap_vox` or more lies between them, so that
/// UAVs far apart do not make one box as large as the map.
std::vector<DirtyBox> DirtyBoxes(const VoxelGrid& grid, std::vector<int> blocks, int gap_vox);

}  // namespace citrine

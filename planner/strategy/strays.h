#pragma once

#include <vector>

#include "core/grid/voxel_grid.h"
#include "planner/view/elements.h"

namespace citrine::planner {

/// Takes away the low-quality elements that stand nearly alone: where no more elements of any kind lie in a
/// cell of a metre and the 26 around it than a row of voxels of length `row_m` has. Noise, and what cannot be
/// seen well at edges, leave such all over the map, each a flight for itself. 0: none is taken away.
void LeaveStrays(std::vector<Element>& elements, const VoxelGrid& grid, double row_m);

}  // namespace citrine::planner

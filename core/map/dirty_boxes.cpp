#include "core/map/dirty_boxes.h"

#include <algorithm>
#include <utility>

namespace citrine {

std::vector<DirtyBox> DirtyBoxes(const VoxelGrid& grid, std::vector<int> blocks, int gap_vox) {
  std::vector<DirtyBox> boxes;
  std::vector<std::vector<int>> open;
  if (!blocks.empty()) open.push_back(std::move(blocks));
  while (!open.empty()) {
    const std::vector<int> group = std::exchange(open.back(), {});
    open.pop_back();
    DirtyBox box{grid.voxels(), VoxelIndex::Zero()};
    for (int block : group) {
      box.min = box.min.cwiseMin(grid.BlockOrigin(block));
      box.max = box.max.cwiseMax((grid.BlockOrigin(block).array() + kBlockSide).matrix());
    }
    // The widest gap between slabs that hold a block.
    int widest = 0, axis_cut = 0, at_cut = 0;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<int> origins;
      for (int block : group) origins.push_back(grid.BlockOrigin(block)[axis]);
      std::sort(origins.begin(), origins.end());
      for (std::size_t i = 1; i < origins.size(); ++i)
        if (const int gap = origins[i] - origins[i - 1] - kBlockSide; gap > widest)
          widest = gap, axis_cut = axis, at_cut = origins[i];
    }
    if (widest < gap_vox || widest == 0) {
      boxes.push_back(box);
      continue;
    }
    std::vector<int> below, above;
    for (int block : group) (grid.BlockOrigin(block)[axis_cut] < at_cut ? below : above).push_back(block);
    open.push_back(std::move(below));
    open.push_back(std::move(above));
  }
  return boxes;
}

}  // namespace citrine

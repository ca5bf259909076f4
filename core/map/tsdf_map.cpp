#include "core/map/tsdf_map.h"

namespace citrine {

TsdfMap::TsdfMap(const VoxelGrid& grid, double truncation_m)
    : grid_(grid), truncation_m_(truncation_m), blocks_(grid.num_blocks()), version_(grid.num_blocks(), 0) {}

TsdfBlock& TsdfMap::Allocate(int block) {
  if (!blocks_[block]) blocks_[block] = std::make_unique<TsdfBlock>();  // value-initialised: unknown
  return *blocks_[block];
}

MapBlock TsdfMap::Quantise(int block, const Quantisation& quantisation) const {
  MapBlock coded;
  coded.index = block;
  coded.version = version_[block];
  const TsdfBlock* full = Find(block);
  if (!full) return coded;
  for (int z = 0; z < kBlockSide; ++z)
    for (int y = 0; y < kBlockSide; ++y)
      for (int x = 0; x < kBlockSide; ++x) {
        const VoxelIndex voxel(x, y, z);
        const int from = TsdfBlock::IndexOf(voxel), to = VoxelGrid::InBlock(voxel);
        if (!(full->weight[from] > 0)) continue;
        coded.distance[to] = quantisation.DistanceCode(full->distance_m[from]);
        if (coded.distance[to] < kFreeCode) coded.weight[to] = quantisation.WeightCode(full->quality[from]);
      }
  return coded;
}

std::size_t TsdfMap::bytes() const {
  std::size_t sum = blocks_.size() * (sizeof(blocks_[0]) + sizeof(version_[0]));
  for (const auto& block : blocks_) sum += block ? sizeof(TsdfBlock) : 0;
  return sum;
}

}  // namespace citrine

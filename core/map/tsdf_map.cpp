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
  for (int i = 0; i < kBlockVoxels; ++i) {
    if (!(full->weight[i] > 0)) continue;
    coded.distance[i] = quantisation.DistanceCode(full->distance_m[i]);
    if (coded.distance[i] < kFreeCode) coded.weight[i] = quantisation.WeightCode(full->quality[i]);
  }
  return coded;
}

std::size_t TsdfMap::bytes() const {
  std::size_t sum = blocks_.size() * (sizeof(blocks_[0]) + sizeof(version_[0]));
  for (const auto& block : blocks_) sum += block ? sizeof(TsdfBlock) : 0;
  return sum;
}

}  // namespace citrine

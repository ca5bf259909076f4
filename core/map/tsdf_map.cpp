#include "core/map/tsdf_map.h"

#include <array>
#include <utility>

#include "core/grid/grid_around.h"

namespace citrine {
namespace {

/// VoxelGrid::InBlock by TsdfBlock::IndexOf.
const std::array<std::int16_t, kBlockVoxels> kInBlockOf = [] {
  std::array<std::int16_t, kBlockVoxels> in_block{};
  for (int z = 0; z < kBlockSide; ++z)
    for (int y = 0; y < kBlockSide; ++y)
      for (int x = 0; x < kBlockSide; ++x)
        in_block[TsdfBlock::IndexOf({x, y, z})] = static_cast<std::int16_t>(VoxelGrid::InBlock({x, y, z}));
  return in_block;
}();

}  // namespace

TsdfMap::TsdfMap(const VoxelGrid& grid, double truncation_m)
    : grid_(grid), truncation_m_(truncation_m), blocks_(grid.num_blocks()), version_(grid.num_blocks(), 0) {}

TsdfBlock& TsdfMap::Allocate(int block) {
  if (!blocks_[block]) blocks_[block] = std::make_unique<TsdfBlock>();  // value-initialised: unknown
  return *blocks_[block];
}

void TsdfMap::GrowTo(const Eigen::AlignedBox3d& box_W) {
  Eigen::AlignedBox3d volume_W = grid_.volume_W();
  if (volume_W.contains(box_W)) return;
  for (int axis = 0; axis < 3; ++axis) {
    const double more_m = volume_W.sizes()[axis] / 2;
    if (box_W.min()[axis] < volume_W.min()[axis]) volume_W.min()[axis] = box_W.min()[axis] - more_m;
    if (box_W.max()[axis] > volume_W.max()[axis]) volume_W.max()[axis] = box_W.max()[axis] + more_m;
  }
  const VoxelGrid larger = GridAround(grid_.voxel_m(), volume_W);
  const VoxelIndex shift =
      ((grid_.origin_W() - larger.origin_W()) / grid_.voxel_m()).array().round().cast<int>();
  std::vector<std::unique_ptr<TsdfBlock>> blocks(static_cast<std::size_t>(larger.num_blocks()));
  std::vector<std::uint32_t> version(blocks.size(), 0);
  for (int block = 0; block < grid_.num_blocks(); ++block) {
    const int to = larger.Block(grid_.BlockOrigin(block) + shift);
    blocks[to] = std::move(blocks_[block]);
    version[to] = version_[block];
  }
  grid_ = larger;
  blocks_ = std::move(blocks);
  version_ = std::move(version);
}

MapBlock TsdfMap::Quantise(int block, const Quantisation& quantisation) const {
  MapBlock coded;
  coded.index = block;
  coded.version = version_[block];
  const TsdfBlock* full = Find(block);
  if (!full) return coded;
  for (int brick = 0; brick < kBlockBricks; ++brick) {
    const bool clear = full->clear_bricks >> brick & 1;
    for (int from = brick * kBrickVoxels; from < (brick + 1) * kBrickVoxels; ++from) {
      const int to = kInBlockOf[from];
      if (clear) {
        coded.distance[to] = kFreeCode;
      } else if (full->weight[from] > 0) {
        coded.distance[to] = quantisation.DistanceCode(full->distance_m[from]);
        if (coded.distance[to] < kFreeCode) coded.weight[to] = quantisation.WeightCode(full->quality[from]);
      }
    }
  }
  return coded;
}

std::size_t TsdfMap::bytes() const {
  std::size_t sum = blocks_.size() * (sizeof(blocks_[0]) + sizeof(version_[0]));
  for (const auto& block : blocks_) sum += block ? sizeof(TsdfBlock) : 0;
  return sum;
}

}  // namespace citrine

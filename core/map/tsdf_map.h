#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/grid/voxel_grid.h"
#include "core/map/map_block.h"
#include "core/map/quantisation.h"

namespace citrine {

/// A brick is 2x2x2 voxels: one vector register, and as small as such a thing can be. A block has 64.
inline constexpr int kBrickSide = 2, kBrickVoxels = 8, kBlockBricks = 64;

/// 8x8x8 voxels of the full map, each field an array of its own, brick by brick (`IndexOf`).
struct alignas(64) TsdfBlock {
  /// [m] signed distance to the surface, averaged by weight, within +-truncation
  float distance_m[kBlockVoxels];
  /// Sum of the weights of the observations that distance_m averages; 0: unknown. A voxel only ever seen free
  /// has a token of one.
  float weight[kBlockVoxels];
  /// Confidence by the mission's weight policy, surface band only (section III-A)
  float quality[kBlockVoxels];
  /// One bit a brick: all of it known and free, and no surface ever seen in it, so that free rays tell
  /// nothing new.
  std::uint64_t clear_bricks;

  /// Where a voxel stands in the arrays above: x, y, z of its place in the block, their bits interleaved, so
  /// that bricks and octants of the block lie together (Morton 1966).
  static int IndexOf(const VoxelIndex& v) {
    const auto spread = [](int i) { return (i & 1) | (i & 2) << 2 | (i & 4) << 4; };
    return spread(v.x()) | spread(v.y()) << 1 | spread(v.z()) << 2;
  }
};

/// The full TSDF (Curless & Levoy 1996): a dense table of blocks on the mission's grid, allocated when first
/// seen.
class TsdfMap {
 public:
  TsdfMap(const VoxelGrid& grid, double truncation_m);

  const VoxelGrid& grid() const { return grid_; }
  double truncation_m() const { return truncation_m_; }

  /// @return nullptr if it was never observed
  const TsdfBlock* Find(int block) const { return blocks_[block].get(); }
  TsdfBlock* Find(int block) { return blocks_[block].get(); }
  TsdfBlock& Allocate(int block);

  /// Takes a block over as it was saved.
  void Restore(int block, const TsdfBlock& saved, std::uint32_t version) {
    Allocate(block) = saved;
    version_[block] = version;
  }

  /// Makes the grid, one of GridAround(), hold a box: half as large again on the sides where it has to grow,
  /// so that it seldom has to. Numbers of blocks change.
  void GrowTo(const Eigen::AlignedBox3d& box_W);

  /// Counts up whenever a scan changed the block; 0: never.
  std::uint32_t version(int block) const { return version_[block]; }
  void MarkChanged(int block) { ++version_[block]; }

  /// The block as it travels.
  MapBlock Quantise(int block, const Quantisation& quantisation) const;

  std::size_t bytes() const;

 private:
  VoxelGrid grid_;
  double truncation_m_;
  std::vector<std::unique_ptr<TsdfBlock>> blocks_;
  std::vector<std::uint32_t> version_;
};

}  // namespace citrine

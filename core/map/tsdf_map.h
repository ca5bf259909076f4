#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/grid/voxel_grid.h"
#include "core/map/map_block.h"
#include "core/map/quantisation.h"

namespace citrine {

/// 8x8x8 voxels of the full map, each field an array of its own so that a row of eight is one vector
/// register.
struct alignas(64) TsdfBlock {
  float
      distance_m[kBlockVoxels];  ///< signed distance to the surface, averaged by weight, within +-truncation
  float weight[kBlockVoxels];    ///< sum of the weights of all observations; 0: unknown
  float quality[kBlockVoxels];   ///< confidence by the mission's weight policy, surface band only (section
                                 ///< III-A)
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

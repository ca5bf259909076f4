#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "fusion/scan_view.h"

namespace citrine::fusion {

/// Finds the bricks of some blocks of which a scan may tell something, from blocks over octants to bricks.
///
/// Each level is looked at for all blocks before the next is, since what one sight waits for another can
/// compute.
class BrickFinder {
 public:
  /// A cube of voxels: a block, an octant of one, or a brick.
  struct Cube {
    int block;                 ///< in the order added
    int first_brick;           ///< of the block
    Eigen::Vector3f lowest_S;  ///< [m] centre of its lowest voxel, sensor frame
  };
  /// Bricks that the scan sees to be free, one bit each from `first_brick` on.
  struct Free {
    int block, first_brick, bricks;
    float farthest_m;  ///< that was seen around them
  };

  /// Forgets all blocks; their memory is used again.
  void Clear() {
    blocks_.clear();
    clear_.clear();
  }
  /// @param lowest_S  [m] centre of the block's lowest voxel @param clear_bricks  see TsdfBlock
  void Add(const Eigen::Vector3f& lowest_S, std::uint64_t clear_bricks) {
    blocks_.push_back({static_cast<int>(blocks_.size()), 0, lowest_S});
    clear_.push_back(clear_bricks);
  }
  void Find(const ScanView& view);

  std::span<const Free> free() const { return free_; }
  /// Those to be observed voxel by voxel.
  std::span<const Cube> bricks() const { return bricks_; }

 private:
  int ClearOf(const Cube& octant) const { return clear_[octant.block] >> octant.first_brick & 0xff; }

  std::vector<Cube> blocks_, octants_, bricks_;
  std::vector<std::uint64_t> clear_;  ///< one a block
  std::vector<EightCubes> parts_;
  std::vector<Free> free_;
};

}  // namespace citrine::fusion

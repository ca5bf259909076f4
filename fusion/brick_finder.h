#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "core/map/tsdf_map.h"
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
  /// Bricks never observed that the scan sees to be free, one bit each from `first_brick` on.
  struct Free {
    int block, first_brick, bricks;
  };

  /// Forgets all blocks; their memory is used again.
  void Clear() {
    blocks_.clear();
    known_.clear();
  }
  /// @param lowest_S  [m] centre of the block's lowest voxel @param known  nullptr: never observed
  void Add(const Eigen::Vector3f& lowest_S, const TsdfBlock* known) {
    blocks_.push_back({static_cast<int>(blocks_.size()), 0, lowest_S});
    known_.push_back(known);
  }
  void Find(const ScanView& view);

  std::span<const Free> free() const { return free_; }
  /// Those to be observed voxel by voxel.
  std::span<const Cube> bricks() const { return bricks_; }

 private:
  /// Of the eight bricks of an octant, one bit each.
  int ClearOf(const Cube& octant) const {
    const TsdfBlock* known = known_[octant.block];
    return known ? static_cast<int>(known->clear_bricks >> octant.first_brick & 0xff) : 0;
  }
  bool NeverObserved(int block, int first_brick, int bricks) const;

  std::vector<Cube> blocks_, octants_, bricks_;
  std::vector<const TsdfBlock*> known_;  ///< one a block
  std::vector<EightCubes> parts_;
  std::vector<Free> free_;
};

}  // namespace citrine::fusion

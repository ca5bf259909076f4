#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "core/grid/voxel_grid.h"
#include "core/map/distance_field.h"
#include "core/map/map_block.h"
#include "core/map/quantisation.h"

namespace citrine {

/// A voxel's class (paper, section III-A), from its quantised distance.
enum class VoxelState : std::uint8_t { kUnknown = 0, kEmpty = 1, kOccupied = 2 };

/// The map that decisions are made on: the quantised blocks of the bus on a dense grid, the class of every
/// voxel, and the exact distance to what is occupied and to what is unknown.
///
/// Beyond the mission volume the class is that of the code all the same: definitions of the paper ask
/// VoxelGrid::Inside first. What was seen there (the ground under the lower face) keeps its distance in
/// `to_occupied`.
///
/// One writer; everybody in a process who hears the same blocks shares one. `Apply` blocks, then `Update`
/// once.
class PlanningMap {
 public:
  /// Reach of the two distance fields [m]. Clearance beyond it reads as it.
  static constexpr double kOccupiedReach_m = 3.0;
  static constexpr double kUnknownReach_m = 1.5;

  /// Voxels nearer to the surface than this count as obstacles [voxels]: those that it passes.
  static constexpr double kSiteBelow_vox = 0.5;
  /// What clearance is read too small by on purpose [voxels]: at an edge the centre of the next such voxel
  /// may lie 0.95 voxel behind it.
  static constexpr double kCaution_vox = 0.45;

  struct Ball {
    Eigen::Vector3d p_W;
    double radius_m;
  };

  PlanningMap(const VoxelGrid& grid, const Quantisation& quantisation);

  /// Counts a ball around a spawn as known free in the unknown-distance field, and there alone (design,
  /// section 6).
  void AssumeFree(const Ball& ball);

  /// Takes a block over if it is newer than the one held. @return whether anything changed
  /// @throws std::out_of_range for a block that the grid does not have
  bool Apply(const MapBlock& block);

  /// Brings the distance fields up to date with the blocks applied since. @return whether anything had
  /// changed
  /// @param meanwhile  called then, on other threads as far as there are: may ask for all but distances
  bool Update(const std::vector<std::function<void()>>& meanwhile = {});

  const VoxelGrid& grid() const { return grid_; }
  const Quantisation& quantisation() const { return quantisation_; }

  VoxelState state(std::size_t linear) const { return static_cast<VoxelState>(state_[linear]); }
  const std::vector<std::uint8_t>& states() const { return state_; }
  const std::vector<std::uint8_t>& distance_codes() const { return distance_; }
  std::uint8_t distance_code(std::size_t linear) const { return distance_[linear]; }
  std::uint8_t weight_code(std::size_t linear) const { return weight_[linear]; }
  double distance_m(std::size_t linear) const { return quantisation_.Distance(distance_[linear]); }
  double weight(std::size_t linear) const { return quantisation_.Weight(weight_[linear]); }

  /// [m] to the centre of the nearest voxel that is known and d < kSiteBelow_vox d_s, less kCaution_vox d_s.
  /// Over by half a voxel at most; before flat surfaces under by half a voxel on average, a voxel at most.
  const DistanceField& to_occupied() const { return to_occupied_; }
  /// [m] to the nearest unknown voxel inside the mission volume.
  const DistanceField& to_unknown() const { return to_unknown_; }

  std::uint32_t block_version(int block) const { return version_[block]; }
  /// Counts calls of Update() that changed something.
  std::int64_t revision() const { return revision_; }
  /// Blocks changed by the last Update() that changed something.
  const std::vector<int>& changed_blocks() const { return changed_; }

  /// Number of blocks known and the digest over them, as in MapSummary.
  int num_blocks_known() const { return num_blocks_known_; }
  std::uint64_t Digest() const;

 private:
  struct SiteChange {
    bool any = false, occupied = false, unknown = false;
  };
  /// Writes one row of eight voxels. @return what changed
  SiteChange WriteRow(std::size_t linear, const std::uint8_t* distance, const std::uint8_t* weight);

  VoxelGrid grid_;
  Quantisation quantisation_;
  std::vector<std::uint8_t> distance_, weight_, state_;
  std::vector<std::uint8_t> occupied_site_, unknown_site_;
  std::vector<std::uint32_t> version_;
  std::vector<std::uint8_t> never_unknown_;  ///< outside the mission volume, or in a start ball
  DistanceField to_occupied_, to_unknown_;
  std::vector<int> pending_, pending_occupied_, pending_unknown_, changed_;
  std::array<std::uint8_t, 256> state_of_{}, occupied_of_{};  ///< by distance code
  int num_blocks_known_ = 0;
  std::int64_t revision_ = 0;
};

}  // namespace citrine

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "planner/path/safe_space.h"

namespace citrine::planner {

/// The safe voxels that are connected to a UAV: where it can go through space known to be free, or where it
/// could if unknown space were free.
///
/// A flood fill over voxels, 64 at a time; voxels are neighbours over faces. Call Update before asking.
class ReachableSet {
 public:
  ReachableSet(const PlanningMap& map, const VehicleLimits& limits, double margin_m,
               Unknown unknown = Unknown::kObstacle);

  /// Brings the set up to date with the map and the place that it begins at. A start that is not safe (noise
  /// of the map) begins at the nearest safe voxel within 3 m; without one the set is empty.
  void Update(const Eigen::Vector3d& from_W);

  bool Reaches(const VoxelIndex& v) const { return space_.map().grid().Inside(v) && ReachesInside(v); }
  bool Reaches(const Eigen::Vector3d& p_W) const { return Reaches(space_.map().grid().IndexOf(p_W)); }
  /// As above for a voxel inside the mission volume.
  bool ReachesInside(const VoxelIndex& v) const {
    return reached_[Row(v.y(), v.z()) + static_cast<std::size_t>(v.x() >> 6)] >> (v.x() & 63) & 1;
  }

  /// The reached voxel whose centre is nearest to a point within `reach_m`, the lowest index of equals.
  std::optional<VoxelIndex> Nearest(const Eigen::Vector3d& p_W, double reach_m) const;

  /// Where the flood began. nullopt: nowhere, the set is empty
  const std::optional<VoxelIndex>& origin() const { return origin_; }
  const SafeSpace& space() const { return space_; }
  std::size_t size() const;

 private:
  std::size_t Row(int y, int z) const {
    return words_ *
           (static_cast<std::size_t>(y) + static_cast<std::size_t>(space_.map().grid().voxels().y()) * z);
  }
  void ReadSafeVoxels();
  void Flood(const VoxelIndex& origin);

  SafeSpace space_;
  std::size_t words_;                          ///< a row of voxels along x
  std::vector<std::uint64_t> safe_, reached_;  ///< one bit a voxel
  std::vector<std::uint64_t> seeds_;           ///< of the flood: bits that wait, by word
  std::vector<std::uint32_t> queue_;
  std::optional<VoxelIndex> origin_;
  std::int64_t revision_ = -1;
};

}  // namespace citrine::planner

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/map/planning_map.h"
#include "core/map/tsdf_map.h"

namespace citrine {

/// Occupancy view of a planning map as an OctoMap octree: occupied where the surface passes (d < d_s / 2),
/// free where else it is known. A leaf holds the voxel whose centre it contains; they coincide if the volume
/// lies on multiples of d_s.
class OccupancyTree {
 public:
  OccupancyTree();
  ~OccupancyTree();

  /// Follows the map: only voxels of blocks that changed since are set again.
  void Update(const PlanningMap& map);

  /// The whole of a full map, by the same rule.
  void Add(const TsdfMap& map);

  /// OctoMap's binary stream with its header: what a .bt file holds, and octomap::OcTree::readBinary reads.
  std::vector<std::uint8_t> Bytes() const;
  /// @throws std::runtime_error naming the file if it cannot be written
  void WriteBt(const std::string& path) const;

  /// What the leaf at a point holds.
  enum class Leaf { kUnknown, kFree, kOccupied };
  Leaf At(const Eigen::Vector3d& p_W) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace citrine

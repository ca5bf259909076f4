#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/map/planning_map.h"
#include "core/map/tsdf_map.h"

namespace citrine {

/// Occupancy view of a planning map as an OctoMap octree (Hornung et al. 2013): occupied where the surface
/// passes (d < d_s / 2), free where else it is known. A leaf holds the voxel whose centre it contains; they
/// coincide if the volume lies on multiples of d_s.
///
/// The octree exists as its binary stream alone. Leaves lie in cubes of 8x8x8, each a subtree of the octree
/// that keeps its part of the stream; it is written again only where a leaf has changed.
class OccupancyTree {
 public:
  /// What a leaf holds. Numbered as in the stream.
  enum class Leaf : std::uint8_t { kUnknown = 0, kFree = 1, kOccupied = 2 };

  /// Follows the map: only voxels of blocks that changed since are set again. What was known stays.
  void Update(const PlanningMap& map);

  /// The whole of a full map, by the same rule.
  void Add(const TsdfMap& map);

  /// OctoMap's binary stream with its header: what a .bt file holds, and octomap::OcTree::readBinary reads.
  /// After the header each inner node is two bits for each of its children (0 unknown, 1 a free leaf, 2 an
  /// occupied one, 3 an inner node), x running fastest, followed by its inner children in that order.
  std::vector<std::uint8_t> Bytes() const;
  /// @throws std::runtime_error naming the file if it cannot be written
  void WriteBt(const std::string& path) const;

  /// What the leaf at a point holds.
  Leaf At(const Eigen::Vector3d& p_W) const;

 private:
  struct Cube {
    unsigned bits = 0;                ///< in its parent
    bool changed = false;             ///< since it was written
    std::vector<std::uint8_t> bytes;  ///< its part of the stream; empty if its leaves are alike
  };

  /// Makes leaves for all of a grid, once.
  void Cover(const VoxelGrid& grid);
  /// OctoMap's key of the leaf at a point: leaves are counted from the lowest corner of its tree.
  VoxelIndex KeyOf(const Eigen::Vector3d& p_W) const;
  /// Whether there are leaves in a node 2^level leaves wide; such nodes are counted from that corner, too.
  bool Covers(int level, const VoxelIndex& node) const;
  /// Where a leaf is kept.
  std::size_t LeafAt(const VoxelIndex& key) const;
  void Set(const VoxelIndex& voxel, Leaf leaf);
  void WriteChangedCubes();
  /// Appends what hangs under a node. @return its bits in its parent
  unsigned AppendNode(int level, const VoxelIndex& node, std::vector<std::uint8_t>& bytes) const;

  double leaf_m_ = 1;
  VoxelIndex first_key_ = VoxelIndex::Zero(), last_key_ = VoxelIndex::Constant(-1);  ///< of the grid's voxels
  std::array<std::vector<std::size_t>, 3> along_;  ///< LeafAt() of a voxel's key is a sum over axes
  std::vector<Leaf> leaves_;  ///< cube by cube, in the octree's order, which is that of TsdfBlock::IndexOf
  std::vector<Cube> cubes_;
  std::vector<std::uint32_t> version_;  ///< of the blocks as last looked at
};

}  // namespace citrine

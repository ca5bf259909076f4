#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/map/tri_mesh.h"
#include "core/map/tsdf_map.h"
#include "fusion/cube_cases.h"

namespace citrine::fusion {

/// Marching cubes over the cells whose lowest corner lies in one block. Vertices are shared with the blocks
/// that were added to the same mesh before.
class BlockSurface {
 public:
  explicit BlockSurface(const TsdfMap& map);

  /// Appends what a block has of the surface; nothing if it has none.
  void AddTo(TriMesh& mesh, int block);
  /// What comes next goes to a mesh of its own.
  void Forget();

 private:
  static constexpr int kSide = kBlockSide + 1;  // voxels along an edge: those of the block and the next
  using EdgeVertices = std::array<int, 3 * kBlockVoxels>;

  bool MayCross(int block) const;
  void Sample(int block);
  void SampleFrom(int block, const VoxelIndex& offset);
  unsigned Crossed(int y, int z) const;
  bool Jumps(int x, int y, int z, int inside) const;
  int Vertex(const VoxelIndex& in_block, const CubeEdge& edge, TriMesh& mesh);

  const TsdfMap& map_;
  VoxelIndex origin_ = VoxelIndex::Zero();
  VoxelIndex first_ = VoxelIndex::Zero(), last_ = VoxelIndex::Zero();  ///< cells that meet the mission volume
  std::array<float, kSide * kSide * kSide> distance_m_, quality_;
  std::array<unsigned, kSide * kSide> negative_, unknown_;  ///< one bit a voxel along x, for each y and z
  std::vector<std::unique_ptr<EdgeVertices>> vertices_;     ///< by block; -1: none
  std::vector<int> touched_;                                ///< blocks that have such a table
};

}  // namespace citrine::fusion

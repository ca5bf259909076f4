#pragma once

#include <vector>

#include "core/map/tri_mesh.h"
#include "core/map/tsdf_map.h"
#include "fusion/block_surface.h"

namespace citrine::fusion {

/// The surface of a map inside the mission volume by marching cubes, its vertices shared and their confidence
/// the voxels' quality.
///
/// A cell takes part if it meets the volume, all its eight voxels are known, and the distance does not jump
/// between two of them by more than a surface can make it: the back of what was seen from one side only is no
/// surface.
TriMesh SurfaceMesh(const TsdfMap& map);

/// The same surface in pieces, one a block, for viewers that follow a map while it grows.
class BlockMeshes {
 public:
  /// @param map  must outlive this, and keep its grid
  explicit BlockMeshes(const TsdfMap& map);

  /// Meshes anew what the change of some blocks can have changed: them and their neighbours below, whose
  /// outer cells reach into them. @return those whose pieces differ from before, ascending
  std::vector<int> Update(const std::vector<int>& changed);

  /// Piece of the surface; empty if the block has none.
  const TriMesh& Of(int block) const { return pieces_[block]; }

 private:
  const TsdfMap& map_;
  BlockSurface surface_;
  std::vector<TriMesh> pieces_;
};

}  // namespace citrine::fusion

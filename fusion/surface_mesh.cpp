#include "fusion/surface_mesh.h"

#include <algorithm>
#include <utility>

namespace citrine::fusion {

TriMesh SurfaceMesh(const TsdfMap& map) {
  TriMesh mesh;
  BlockSurface surface(map);
  for (int block = 0; block < map.grid().num_blocks(); ++block) surface.AddTo(mesh, block);
  return mesh;
}

BlockMeshes::BlockMeshes(const TsdfMap& map)
    : map_(map), surface_(map), pieces_(static_cast<std::size_t>(map.grid().num_blocks())) {}

std::vector<int> BlockMeshes::Update(const std::vector<int>& changed) {
  const VoxelGrid& grid = map_.grid();
  std::vector<int> to_mesh;
  for (const int block : changed)
    for (int i = 0; i < 8; ++i) {
      const VoxelIndex below = grid.BlockOrigin(block) - kBlockSide * VoxelIndex(i & 1, i >> 1 & 1, i >> 2);
      if (grid.Contains(below)) to_mesh.push_back(grid.Block(below));
    }
  std::sort(to_mesh.begin(), to_mesh.end());
  to_mesh.erase(std::unique(to_mesh.begin(), to_mesh.end()), to_mesh.end());
  std::vector<int> differ;
  for (const int block : to_mesh) {
    TriMesh piece;
    surface_.Forget();
    surface_.AddTo(piece, block);
    const TriMesh& before = pieces_[block];
    if (piece.vertices_W == before.vertices_W && piece.triangles == before.triangles &&
        piece.confidence == before.confidence)
      continue;
    pieces_[block] = std::move(piece);
    differ.push_back(block);
  }
  return differ;
}

}  // namespace citrine::fusion

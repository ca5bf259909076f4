#include "fusion/block_surface.h"

#include <algorithm>
#include <cmath>

#include "fusion/lanes.h"

namespace citrine::fusion {
namespace {

constexpr float kLargestJump_vox = 2.0f;  // of the distance, from a voxel to the next

VoxelIndex CornerOf(int corner) { return {corner & 1, corner >> 1 & 1, corner >> 2}; }

bool AnyBelowZero(const TsdfBlock& block) {
  Mask below = Mask::Nowhere();
  for (int i = 0; i < kBlockVoxels; i += kBrickVoxels) below = below | (Load(&block.distance_m[i]) < 0.0f);
  return below.any();
}

}  // namespace

BlockSurface::BlockSurface(const TsdfMap& map)
    : map_(map),
      first_((map.grid().inside_min().array() - 1).max(0)),
      last_(map.grid().inside_max().array().min(map.grid().voxels().array() - 1)),
      vertices_(static_cast<std::size_t>(map.grid().num_blocks())) {}

void BlockSurface::Forget() {
  for (const int block : touched_) vertices_[block].reset();
  touched_.clear();
}

void BlockSurface::AddTo(TriMesh& mesh, int block) {
  if (!map_.Find(block) || !MayCross(block)) return;
  Sample(block);
  for (int z = 0; z < kBlockSide; ++z)
    for (int y = 0; y < kBlockSide; ++y)
      for (unsigned cells = Crossed(y, z); cells != 0; cells &= cells - 1) {
        const int x = __builtin_ctz(cells);
        int inside = 0;
        for (int corner = 0; corner < 8; ++corner) {
          const int row = (z + (corner >> 2)) * kSide + y + (corner >> 1 & 1);
          inside |= static_cast<int>(negative_[row] >> (x + (corner & 1)) & 1) << corner;
        }
        if (Jumps(x, y, z, inside)) continue;
        for (const CubeTriangle& triangle : CubeCases()[inside])
          mesh.triangles.push_back({Vertex({x, y, z}, triangle[0], mesh),
                                    Vertex({x, y, z}, triangle[1], mesh),
                                    Vertex({x, y, z}, triangle[2], mesh)});
      }
}

bool BlockSurface::MayCross(int block) const {
  const VoxelGrid& grid = map_.grid();
  const VoxelIndex origin = grid.BlockOrigin(block);
  for (int i = 0; i < 8; ++i) {
    const VoxelIndex at = origin + kBlockSide * CornerOf(i);
    const TsdfBlock* next = grid.Contains(at) ? map_.Find(grid.Block(at)) : nullptr;
    if (next && next->clear_bricks != ~std::uint64_t{0} && AnyBelowZero(*next)) return true;
  }
  return false;
}

void BlockSurface::Sample(int block) {
  const VoxelGrid& grid = map_.grid();
  origin_ = grid.BlockOrigin(block);
  negative_.fill(0);
  unknown_.fill(~0u);
  for (int i = 0; i < 8; ++i) {
    const VoxelIndex at = origin_ + kBlockSide * CornerOf(i);
    if (grid.Contains(at)) SampleFrom(grid.Block(at), kBlockSide * CornerOf(i));
  }
}

void BlockSurface::SampleFrom(int block, const VoxelIndex& offset) {
  const TsdfBlock* from = map_.Find(block);
  if (!from) return;
  const VoxelIndex count = (kSide - offset.array()).min(kBlockSide);
  for (int z = 0; z < count.z(); ++z)
    for (int y = 0; y < count.y(); ++y)
      for (int x = 0; x < count.x(); ++x) {
        const int i = TsdfBlock::IndexOf({x, y, z}), row = (z + offset.z()) * kSide + y + offset.y();
        if (!(from->weight[i] > 0)) continue;
        const int at_x = x + offset.x();
        distance_m_[row * kSide + at_x] = from->distance_m[i];
        quality_[row * kSide + at_x] = from->quality[i];
        negative_[row] |= static_cast<unsigned>(from->distance_m[i] < 0) << at_x;
        unknown_[row] &= ~(1u << at_x);
      }
}

/// Cells of a row, one bit each, that take part: all eight corners known, some inside and some outside.
unsigned BlockSurface::Crossed(int y, int z) const {
  const VoxelIndex cell = origin_ + VoxelIndex(0, y, z);
  if (cell.y() < first_.y() || cell.y() >= last_.y() || cell.z() < first_.z() || cell.z() >= last_.z())
    return 0;
  unsigned any = 0, all = ~0u, unknown = 0;
  for (const int row : {z * kSide + y, z * kSide + y + 1, (z + 1) * kSide + y, (z + 1) * kSide + y + 1}) {
    any |= negative_[row];
    all &= negative_[row];
    unknown |= unknown_[row];
  }
  unsigned cells = (any | any >> 1) & ~(all & all >> 1) & ~(unknown | unknown >> 1) & 0xff;
  for (int x = 0; x < kBlockSide; ++x)
    if (cell.x() + x < first_.x() || cell.x() + x >= last_.x()) cells &= ~(1u << x);
  return cells;
}

bool BlockSurface::Jumps(int x, int y, int z, int inside) const {
  const float largest_m = kLargestJump_vox * static_cast<float>(map_.grid().voxel_m());
  const auto at = [&](int corner) {
    return distance_m_[((z + (corner >> 2)) * kSide + y + (corner >> 1 & 1)) * kSide + x + (corner & 1)];
  };
  for (int i = 0; i < 8; ++i)
    for (const int j : {i | 1, i | 2, i | 4})
      if ((inside >> i & 1) != (inside >> j & 1) && std::abs(at(i) - at(j)) > largest_m) return true;
  return false;
}

int BlockSurface::Vertex(const VoxelIndex& in_block, const CubeEdge& edge, TriMesh& mesh) {
  const VoxelGrid& grid = map_.grid();
  const VoxelIndex low = in_block + CornerOf(edge.corner), voxel = origin_ + low;
  const int owner = grid.Block(voxel);
  if (!vertices_[owner]) {
    vertices_[owner] = std::make_unique<EdgeVertices>();
    vertices_[owner]->fill(-1);
    touched_.push_back(owner);
  }
  int& vertex = (*vertices_[owner])[3 * TsdfBlock::IndexOf(voxel) + edge.axis];
  if (vertex >= 0) return vertex;
  constexpr std::array<int, 3> kStride{1, kSide, kSide * kSide};
  const int a = low.x() + kSide * (low.y() + kSide * low.z()), b = a + kStride[edge.axis];
  const float share = distance_m_[a] / (distance_m_[a] - distance_m_[b]);
  Eigen::Vector3d p_W = grid.Centre(voxel);
  p_W[edge.axis] += share * grid.voxel_m();
  vertex = static_cast<int>(mesh.vertices_W.size());
  mesh.vertices_W.push_back(p_W.cast<float>());
  mesh.confidence.push_back(quality_[a] + (quality_[b] - quality_[a]) * share);
  return vertex;
}

}  // namespace citrine::fusion

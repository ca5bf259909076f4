#include "fusion/surface_mesh.h"

#include <array>
#include <cmath>

#include "fusion/cube_cases.h"

namespace citrine::fusion {
namespace {

constexpr double kLargestJump_vox = 2.0;  // of the distance, from a voxel to the next

struct Sample {
  float distance_m = 0, quality = 0;
  bool known = false;
};

Sample SampleAt(const TsdfMap& map, const VoxelIndex& voxel) {
  const TsdfBlock* block = map.Find(map.grid().Block(voxel));
  const int i = TsdfBlock::IndexOf(voxel);
  if (!block || !(block->weight[i] > 0)) return {};
  return {block->distance_m[i], block->quality[i], true};
}

VoxelIndex CornerOf(int corner) { return {corner & 1, corner >> 1 & 1, corner >> 2}; }

/// Vertices on the edges that leave the voxels of two neighbouring layers.
class EdgeLayers {
 public:
  explicit EdgeLayers(const VoxelGrid& grid) : nx_(grid.voxels().x()) {
    for (auto& layer : layers_) layer.assign(grid.stride_z() * 3, -1);
  }
  int& At(const VoxelIndex& voxel, int axis) {
    return layers_[voxel.z() & 1][(static_cast<std::size_t>(voxel.y()) * nx_ + voxel.x()) * 3 + axis];
  }
  void Forget(int z) { layers_[z & 1].assign(layers_[z & 1].size(), -1); }

 private:
  int nx_;
  std::array<std::vector<int>, 2> layers_;
};

/// The eight samples of a cell; nothing if it does not take part.
bool SampleCell(const TsdfMap& map, const VoxelIndex& cell, std::array<Sample, 8>& corners, int& inside) {
  inside = 0;
  for (int i = 0; i < 8; ++i) {
    corners[i] = SampleAt(map, cell + CornerOf(i));
    if (!corners[i].known) return false;
    inside |= (corners[i].distance_m < 0) << i;
  }
  if (inside == 0 || inside == 255) return false;
  const double largest_m = kLargestJump_vox * map.grid().voxel_m();
  for (int i = 0; i < 8; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const int j = i | 1 << axis;
      const bool crossing = (inside >> i & 1) != (inside >> j & 1);
      if (crossing && std::abs(corners[i].distance_m - corners[j].distance_m) > largest_m) return false;
    }
  return true;
}

}  // namespace

TriMesh SurfaceMesh(const TsdfMap& map) {
  const VoxelGrid& grid = map.grid();
  TriMesh mesh;
  EdgeLayers edges(grid);
  std::array<Sample, 8> corners;
  int inside = 0;
  const auto vertex_on = [&](const VoxelIndex& cell, const CubeEdge& edge) {
    const VoxelIndex voxel = cell + CornerOf(edge.corner);
    int& vertex = edges.At(voxel, edge.axis);
    if (vertex < 0) {
      const Sample &a = corners[edge.corner], &b = corners[edge.corner | 1 << edge.axis];
      const float share = a.distance_m / (a.distance_m - b.distance_m);
      Eigen::Vector3d p_W = grid.Centre(voxel);
      p_W[edge.axis] += share * grid.voxel_m();
      vertex = static_cast<int>(mesh.vertices_W.size());
      mesh.vertices_W.push_back(p_W.cast<float>());
      mesh.confidence.push_back(a.quality + (b.quality - a.quality) * share);
    }
    return vertex;
  };
  const VoxelIndex first = (grid.inside_min().array() - 1).max(0);
  const VoxelIndex last = grid.inside_max().array().min(grid.voxels().array() - 1);
  for (int z = first.z(); z < last.z(); ++z) {
    edges.Forget(z + 1);
    for (int y = first.y(); y < last.y(); ++y)
      for (int x = first.x(); x < last.x(); ++x) {
        const VoxelIndex cell(x, y, z);
        if (!map.Find(grid.Block(cell))) continue;
        if (!SampleCell(map, cell, corners, inside)) continue;
        for (const CubeTriangle& triangle : CubeCases()[inside])
          mesh.triangles.push_back(
              {vertex_on(cell, triangle[0]), vertex_on(cell, triangle[1]), vertex_on(cell, triangle[2])});
      }
  }
  return mesh;
}

}  // namespace citrine::fusion

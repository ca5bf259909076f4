#include "fusion/surface_mesh.h"

#include <map>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "fusion/cube_cases.h"

namespace citrine::fusion {
namespace {

/// A map whose distances are those of a ball, everywhere known.
TsdfMap Ball(const Eigen::Vector3d& centre_W, double radius_m) {
  TsdfMap map(VoxelGrid(0.25, {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(6, 6, 6)}, 0.75), 0.5);
  for (std::size_t i = 0; i < map.grid().num_voxels(); ++i) {
    const VoxelIndex v = map.grid().FromLinear(i);
    TsdfBlock& block = map.Allocate(map.grid().Block(v));
    const double d = (map.grid().Centre(v) - centre_W).norm() - radius_m;
    block.distance_m[TsdfBlock::IndexOf(v)] = static_cast<float>(std::clamp(d, -0.5, 0.5));
    block.weight[TsdfBlock::IndexOf(v)] = 1;
    block.quality[TsdfBlock::IndexOf(v)] = 0.04f;
  }
  return map;
}

int EdgesNotSharedByTwo(const TriMesh& mesh) {
  std::map<std::pair<int, int>, int> uses;  // +1 one way, and the other way once as well
  int open = 0;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, count] : uses) {
    const auto back = uses.find({edge.second, edge.first});
    open += count != 1 || back == uses.end() || back->second != 1;
  }
  return open;
}

TEST(SurfaceMesh, OfABallIsClosedNearTheSphereAndFacesOutwards) {
  const Eigen::Vector3d centre(3.03, 2.96, 3.1);
  const TriMesh mesh = SurfaceMesh(Ball(centre, 2.0));
  ASSERT_GT(mesh.triangles.size(), 1000u);
  EXPECT_EQ(EdgesNotSharedByTwo(mesh), 0);
  EXPECT_EQ(static_cast<int>(mesh.vertices_W.size()) - static_cast<int>(mesh.triangles.size()) / 2,
            2);  // Euler
  for (const Eigen::Vector3f& p : mesh.vertices_W)
    EXPECT_NEAR((p.cast<double>() - centre).norm(), 2.0, 0.01);  // chord of a voxel on this radius: 4 mm
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f a = mesh.vertices_W[t[0]], b = mesh.vertices_W[t[1]], c = mesh.vertices_W[t[2]];
    const Eigen::Vector3f normal = (b - a).cross(c - a);
    EXPECT_GE(normal.dot(a - centre.cast<float>()), -1e-6f);
  }
  for (const float confidence : mesh.confidence) EXPECT_FLOAT_EQ(confidence, 0.04f);
}

TEST(SurfaceMesh, HasNoSurfaceWhereAVoxelIsUnknownOrTheDistanceJumps) {
  TsdfMap map = Ball({3, 3, 3}, 2.0);
  for (int block = 0; block < map.grid().num_blocks(); ++block)
    for (float& distance : map.Find(block)->distance_m) distance = distance > 0 ? 0.5f : -0.5f;
  EXPECT_TRUE(SurfaceMesh(map).triangles.empty());
  TsdfMap unknown = Ball({3, 3, 3}, 2.0);
  for (int block = 0; block < unknown.grid().num_blocks(); ++block)
    for (int i = 0; i < kBlockVoxels; ++i)
      if (unknown.Find(block)->distance_m[i] < 0) unknown.Find(block)->weight[i] = 0;
  EXPECT_TRUE(SurfaceMesh(unknown).triangles.empty());
}

TEST(SurfaceMesh, IncludesAGroundOnTheLowerFaceOfTheVolume) {
  TsdfMap map = Ball({3, 3, -50}, 50.0);
  const TriMesh mesh = SurfaceMesh(map);
  ASSERT_FALSE(mesh.triangles.empty());
  for (const Eigen::Vector3f& p : mesh.vertices_W) EXPECT_LT(p.z(), 0.01f);
}

std::multiset<std::array<float, 9>> Corners(const TriMesh& mesh) {
  std::multiset<std::array<float, 9>> corners;
  for (const auto& t : mesh.triangles) {
    std::array<float, 9> nine;
    for (int k = 0; k < 9; ++k) nine[k] = mesh.vertices_W[t[k / 3]][k % 3];
    corners.insert(nine);
  }
  return corners;
}

TEST(BlockMeshes, FollowAMapThatChangesAndTogetherAreItsWholeMesh) {
  TsdfMap map = Ball({3, 3, 3}, 1.5);
  BlockMeshes meshes(map);
  std::vector<int> all(static_cast<std::size_t>(map.grid().num_blocks()));
  std::iota(all.begin(), all.end(), 0);
  const auto together = [&] {
    std::multiset<std::array<float, 9>> corners;
    for (const int block : all) corners.merge(Corners(meshes.Of(block)));
    return corners;
  };
  EXPECT_FALSE(meshes.Update(all).empty());
  EXPECT_EQ(together(), Corners(SurfaceMesh(map)));
  EXPECT_TRUE(meshes.Update(all).empty());
  // A bump in one block, at its lower corner, so that the cells of its neighbours below change as well.
  const int block = map.grid().Block(map.grid().IndexOf({4.5, 3, 3}));
  for (int i = 0; i < kBlockVoxels; ++i) map.Find(block)->distance_m[i] -= 0.05f;
  const std::vector<int> differ = meshes.Update({block});
  EXPECT_LE(differ.size(), 8u);
  EXPECT_TRUE(std::find(differ.begin(), differ.end(), block) != differ.end());
  EXPECT_EQ(together(), Corners(SurfaceMesh(map)));
}

TEST(CubeCases, NeighbouringCubesAgreeOnTheFaceBetweenThem) {
  // Random signs on a block of cells, the border outside: whatever the ambiguities, the surface is closed.
  TsdfMap map(VoxelGrid(0.25, {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, 3, 3)}, 0.75), 0.5);
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < map.grid().num_voxels(); ++i) {
    const VoxelIndex v = map.grid().FromLinear(i);
    TsdfBlock& block = map.Allocate(map.grid().Block(v));
    state = state * 1664525 + 1013904223;
    const bool inner = (v.array() > map.grid().inside_min().array()).all() &&
                       (v.array() + 1 < map.grid().inside_max().array()).all();
    block.distance_m[TsdfBlock::IndexOf(v)] = inner && (state >> 16 & 1) ? -0.1f : 0.1f;
    block.weight[TsdfBlock::IndexOf(v)] = 1;
  }
  const TriMesh mesh = SurfaceMesh(map);
  std::map<std::pair<int, int>, int> balance;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      ++balance[{t[k], t[(k + 1) % 3]}];
      --balance[{t[(k + 1) % 3], t[k]}];
    }
  ASSERT_GT(mesh.triangles.size(), 500u);
  for (const auto& [edge, sum] : balance) EXPECT_EQ(sum, 0);
}

TEST(CubeCases, EmptyAndFullCubesHaveNoTriangles) {
  EXPECT_TRUE(CubeCases()[0].empty());
  EXPECT_TRUE(CubeCases()[255].empty());
  for (int corner = 0; corner < 8; ++corner) EXPECT_EQ(CubeCases()[1 << corner].size(), 1u);
}

}  // namespace
}  // namespace citrine::fusion

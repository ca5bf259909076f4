#include "sim/world/primitives.h"

#include <map>

#include <gmock/gmock.h>
#include <Eigen/Geometry>

namespace citrine::sim {
namespace {

/// Volume by the divergence theorem: positive for closed meshes that are wound outwards.
double Volume(const TriMesh& mesh) {
  double volume = 0;
  for (const auto& t : mesh.triangles)
    volume += mesh.vertices_W[t[0]].cast<double>().dot(
                  mesh.vertices_W[t[1]].cast<double>().cross(mesh.vertices_W[t[2]].cast<double>())) /
              6;
  return volume;
}

/// Directed edges that have no counterpart the other way.
int OpenEdges(const TriMesh& mesh) {
  std::map<std::pair<int, int>, int> balance;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) {
      ++balance[{t[i], t[(i + 1) % 3]}];
      --balance[{t[(i + 1) % 3], t[i]}];
    }
  int open = 0;
  for (const auto& [edge, count] : balance) open += count != 0;
  return open;
}

TEST(Primitives, AreClosed) {
  EXPECT_EQ(OpenEdges(BoxMesh({1, 2, 3})), 0);
  EXPECT_EQ(OpenEdges(CylinderMesh(0.5, 2)), 0);
  EXPECT_EQ(OpenEdges(CapsuleMesh(0.5, 2)), 0);
  EXPECT_EQ(OpenEdges(EllipsoidMesh({1, 2, 0.5})), 0);
}

// An inscribed polyhedron loses at most area x sagitta of volume; the tolerances are that, rounded up.
TEST(Primitives, AreWoundOutwardsAndHaveTheVolumeOfTheirShape) {
  EXPECT_NEAR(Volume(BoxMesh({1, 2, 3})), 6, 1e-5);
  EXPECT_NEAR(Volume(CylinderMesh(0.5, 2)), EIGEN_PI * 0.25 * 2, 0.07);
  EXPECT_NEAR(Volume(CapsuleMesh(0.5, 2)), EIGEN_PI * 0.25 * 2 + 4 / 3.0 * EIGEN_PI * 0.125, 0.10);
  EXPECT_NEAR(Volume(EllipsoidMesh({1, 2, 0.5})), 4 / 3.0 * EIGEN_PI * 1, 0.17);
}

TEST(Primitives, KeepEveryFacetOfACylinderWithinTheSagitta) {
  for (const double radius : {0.025, 0.3, 1.0, 5.0})
    for (const TriMesh mesh = CylinderMesh(radius, 1); const auto& t : mesh.triangles) {
      const Eigen::Vector2f middle = (mesh.vertices_W[t[0]] + mesh.vertices_W[t[1]]).head<2>() / 2;
      if (mesh.vertices_W[t[0]].head<2>().norm() < radius / 2 ||
          mesh.vertices_W[t[1]].head<2>().norm() < radius / 2)
        continue;
      EXPECT_GE(middle.norm(), radius - kSagitta_m - 1e-5);
    }
}

TEST(Primitives, ReachTheExtentsOfTheirShape) {
  Eigen::AlignedBox3f capsule, ellipsoid;
  for (const TriMesh mesh = CapsuleMesh(0.5, 2); const auto& v : mesh.vertices_W) capsule.extend(v);
  for (const TriMesh mesh = EllipsoidMesh({1, 2, 0.5}); const auto& v : mesh.vertices_W) ellipsoid.extend(v);
  EXPECT_NEAR(capsule.sizes().z(), 3, 1e-5);
  EXPECT_NEAR(capsule.sizes().x(), 1, 1e-5);
  EXPECT_NEAR(ellipsoid.sizes().y(), 4, 2 * kSagitta_m);
  EXPECT_NEAR(ellipsoid.sizes().z(), 1, 1e-5);
}

}  // namespace
}  // namespace citrine::sim

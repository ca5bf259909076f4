#include "logs/surface_samples.h"

#include <gtest/gtest.h>

#include "tests/logs/shapes.h"

namespace citrine::logs {
namespace {

TEST(SurfaceSamples, AreAsManyAsAreaTimesDensityAndLieOnTheBox) {
  const TriMesh box = Box({0, 0, 0}, {2, 3, 4});
  ASSERT_NEAR(Area(box), 52, 1e-9);
  const auto points_W = SampleSurface(box, 100, 7);
  EXPECT_EQ(points_W.size(), 5200u);
  const Eigen::Array3f size(2, 3, 4);
  for (const Eigen::Vector3f& p : points_W) {
    // Off the face by no more than the rounding of floats near 4.
    EXPECT_LT(std::min(p.array().abs().minCoeff(), (p.array() - size).abs().minCoeff()), 1e-6f);
    EXPECT_TRUE((p.array() >= -1e-6f).all() && (p.array() <= size + 1e-6f).all());
  }
}

TEST(SurfaceSamples, FillEveryFaceInProportionToItsArea) {
  const auto points_W = SampleSurface(Box({0, 0, 0}, {2, 3, 4}), 50, 3);
  int top = 0, side = 0;
  for (const Eigen::Vector3f& p : points_W) {
    top += p.z() > 4 - 1e-6f;
    side += p.x() < 1e-6f;
  }
  // Each face is two triangles, each of which cuts at most two strata.
  EXPECT_NEAR(top, 6 * 50, 4);
  EXPECT_NEAR(side, 12 * 50, 4);
}

TEST(SurfaceSamples, FillATriangleEvenly) {
  TriMesh mesh;
  mesh.vertices_W = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  const auto points_W = SampleSurface(mesh, 80'000, 3);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& p : points_W) mean += p.cast<double>() / static_cast<double>(points_W.size());
  // The centroid; standard deviation of one coordinate 0.24, of the mean of 40 000 0.0012.
  EXPECT_NEAR((mean - Eigen::Vector3d(1, 1, 0) / 3).norm(), 0, 0.006);
}

TEST(SurfaceSamples, AreTheSameForTheSameSeedAndOthersForAnother) {
  const TriMesh box = Box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(SampleSurface(box, 20, 5), SampleSurface(box, 20, 5));
  EXPECT_NE(SampleSurface(box, 20, 5), SampleSurface(box, 20, 6));
}

TEST(SurfaceSamples, OfAMeshWithoutAreaAreNone) {
  TriMesh flat;
  flat.vertices_W = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  flat.triangles = {{0, 1, 2}};
  EXPECT_TRUE(SampleSurface(flat, 100, 1).empty());
  EXPECT_TRUE(SampleSurface({}, 100, 1).empty());
}

}  // namespace
}  // namespace citrine::logs

#include "sim/world/true_surface.h"

#include <gtest/gtest.h>

#include "tests/sim/box_world.h"

namespace citrine::sim {
namespace {

constexpr double kDensity = 100;

// Systematic sampling places the points of an area to within one; the tolerance is a piece a triangle, and no
// more.
constexpr double kAreaTolerance_m2 = 0.5;

TEST(TrueSurface, SamplesAnAreaInProportionAndNamesItsNormals) {
  const World world = BoxWorld({{"box", Box(0, 0, 0, 1, 2, 3)}});
  const RayScene scene(world);
  const TrueSurface surface = SampleTrueSurface(world, scene, Box(-5, -5, -5, 5, 5, 5), kDensity, 1);
  EXPECT_NEAR(surface.area_m2, 22, kAreaTolerance_m2);
  EXPECT_EQ(surface.dropped_share, 0);
  double top_m2 = 0;
  for (const SurfaceSample& sample : surface.samples) {
    EXPECT_NEAR(scene.Distance(sample.p_W.cast<double>()), 0, 1e-5);
    EXPECT_FALSE(scene.Solid((sample.p_W + 0.05f * sample.n_W).cast<double>()));
    if (sample.n_W.z() > 0.99f) top_m2 += sample.area_m2;
  }
  EXPECT_NEAR(top_m2, 2, 0.1);
}

TEST(TrueSurface, LeavesOutWhereSolidStandsOnSolid) {
  const World world = BoxWorld({{"ground", Box(-5, -5, -1, 5, 5, 0)}, {"box", Box(0, 0, 0, 2, 2, 2)}});
  const RayScene scene(world);
  const TrueSurface surface = SampleTrueSurface(world, scene, Box(-5, -5, 0, 5, 5, 9), kDensity, 1);
  EXPECT_NEAR(surface.area_m2, (100 - 4) + 4 + 16, kAreaTolerance_m2);
  EXPECT_NEAR(surface.dropped_share, 8.0 / (100 + 4 + 4 + 16), 0.01);
  double ground_m2 = 0;
  for (const SurfaceSample& sample : surface.samples) ground_m2 += sample.ground ? sample.area_m2 : 0;
  EXPECT_NEAR(ground_m2, 96, kAreaTolerance_m2);
}

TEST(TrueSurface, LeavesOutWhatOverlappingSolidsHideInEachOther) {
  const World world = BoxWorld({{"a", Box(0, 0, 0, 2, 1, 1)}, {"b", Box(1, 0.25, 0.25, 3, 0.75, 0.75)}});
  const RayScene scene(world);
  // a: 10 m2 less the 0.25 m2 that b leaves through; b: what sticks out by 1 m.
  EXPECT_NEAR(SampleTrueSurface(world, scene, Box(-5, -5, -5, 5, 5, 5), kDensity, 1).area_m2,
              10 - 0.25 + 2 + 0.25, kAreaTolerance_m2);
}

TEST(TrueSurface, KeepsBothSidesOfAThinWallAndAnOpenSheet) {
  World world = BoxWorld({{"wall", Box(0, 0, 0, 3, 0.1, 2)}});
  AddPart(SheetMesh({-2, -2}, {2, 2}), Eigen::Affine3d(Eigen::Translation3d(0, 0, 5)),
          {"sheet", 0, 0, false, false}, world);
  Finish("test", world);
  const RayScene scene(world);
  EXPECT_NEAR(SampleTrueSurface(world, scene, Box(-9, -9, -9, 9, 9, 9), kDensity, 1).area_m2,
              2 * (6 + 0.3 + 0.2) + 16, kAreaTolerance_m2);
}

TEST(TrueSurface, EndsAtTheMissionVolume) {
  const World world = BoxWorld({{"ground", Box(-10, -10, -1, 10, 10, 0)}});
  const RayScene scene(world);
  const TrueSurface surface = SampleTrueSurface(world, scene, Box(-3, -2, 0, 3, 2, 5), kDensity, 1);
  EXPECT_NEAR(surface.area_m2, 24, kAreaTolerance_m2);
  for (const SurfaceSample& sample : surface.samples) EXPECT_LE(std::abs(sample.p_W.x()), 3.001f);
}

TEST(TrueSurface, TakesWhatLiesUnderAPlaneForSolid) {
  World world = BoxWorld({{"box", Box(-1, -1, 0, 1, 1, 1)}});
  AddPart(SheetMesh({-5, -5}, {5, 5}), Eigen::Affine3d::Identity(), {"ground", 0, 0, true, true}, world);
  Finish("test", world);
  const RayScene scene(world);
  EXPECT_NEAR(SampleTrueSurface(world, scene, Box(-9, -9, -9, 9, 9, 9), kDensity, 1).area_m2,
              (100 - 4) + 4 + 8, kAreaTolerance_m2);
}

TEST(TrueSurface, IsTheSameForTheSameSeedAlone) {
  const World world = BoxWorld({{"box", Box(0, 0, 0, 1, 2, 3)}});
  const RayScene scene(world);
  const auto sample = [&](std::uint64_t seed) {
    return SampleTrueSurface(world, scene, Box(-5, -5, -5, 5, 5, 5), kDensity, seed).samples.at(7).p_W;
  };
  EXPECT_EQ(sample(1), sample(1));
  EXPECT_NE(sample(1), sample(2));
}

}  // namespace
}  // namespace citrine::sim

#include "sim/lidar/ray_scene.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "tests/sim/box_world.h"

namespace citrine::sim {
namespace {

constexpr double kFloatTolerance_m = 1e-4;  // coordinates of some tens of metres in 32 bits

Eigen::Vector3d RandomPoint(Random& random, double reach_m) {
  return {random.Uniform(-reach_m, reach_m), random.Uniform(-reach_m, reach_m),
          random.Uniform(-reach_m, reach_m)};
}

TEST(RayScene, MeasuresTheDistanceToABoxAsItsFormulaDoes) {
  const Eigen::AlignedBox3d box = Box(-1, -2, 0, 3, 1, 2);
  const RayScene scene(BoxWorld({{"box", box}}));
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector3d p_W = RandomPoint(random, 8);
    const double inside_m = std::min((p_W - box.min()).minCoeff(), (box.max() - p_W).minCoeff());
    const double truth_m = box.contains(p_W) ? inside_m : box.exteriorDistance(p_W);
    EXPECT_NEAR(scene.Distance(p_W), truth_m, kFloatTolerance_m);
    EXPECT_NEAR(scene.Distance(p_W, 1.5), std::min(truth_m, 1.5), kFloatTolerance_m);
  }
}

TEST(RayScene, CastsPacketsAsSingleRays) {
  const RayScene scene(BoxWorld({{"a", Box(-1, -2, 0, 3, 1, 2)}, {"b", Box(-9, -9, -2, 9, 9, -1)}}));
  Random random(2);
  std::vector<Eigen::Vector3f> directions;
  for (int i = 0; i < 10003; ++i) directions.push_back(RandomPoint(random, 1).normalized().cast<float>());
  const Eigen::Vector3f origin_W(-3, 0.5f, 3);
  std::vector<float> ranges_m(directions.size());
  scene.Cast(origin_W, directions, 20, ranges_m);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const RayScene::Hit hit = scene.CastOne(origin_W, directions[i], 20);
    EXPECT_EQ(std::isfinite(ranges_m[i]), hit.triangle >= 0);
    if (hit.triangle < 0) continue;
    EXPECT_NEAR(ranges_m[i], hit.range_m, kFloatTolerance_m);
  }
}

TEST(RayScene, MeetsASheetFromBothSides) {
  World world;
  AddPart(SheetMesh({-1, -1}, {1, 1}), Eigen::Affine3d::Identity(), {"sheet", 0, 0, false, false}, world);
  Finish("test", world);
  const RayScene scene(world);
  EXPECT_NEAR(scene.CastOne({0.1f, 0.2f, 2}, -Eigen::Vector3f::UnitZ(), 9).range_m, 2, kFloatTolerance_m);
  EXPECT_NEAR(scene.CastOne({0.1f, 0.2f, -3}, Eigen::Vector3f::UnitZ(), 9).range_m, 3, kFloatTolerance_m);
  EXPECT_FALSE(scene.Solid({0, 0, 0.1}));
  EXPECT_FALSE(scene.Solid({0, 0, -0.1}));
}

TEST(RayScene, SeesATargetOnASurfaceButNotBehindIt) {
  const RayScene scene(BoxWorld({{"wall", Box(0, -5, 0, 1, 5, 5)}}));
  const Eigen::Vector3f from_W(-3, 0, 1);
  EXPECT_FALSE(scene.Occluded(from_W, {0, 0.5f, 1}));
  EXPECT_FALSE(scene.Occluded(from_W, {0.015f, 0, 1}));  // within the tolerance
  EXPECT_TRUE(scene.Occluded(from_W, {0.05f, 0, 1}));
  EXPECT_TRUE(scene.Occluded(from_W, {1, 0, 1}));
  EXPECT_FALSE(scene.Occluded(from_W, {3, 0, 12}));  // over the wall
}

TEST(RayScene, KnowsSolidFromFreeInOverlappingBoxesBeyondAnyParity) {
  const std::vector<std::pair<std::string, Eigen::AlignedBox3d>> boxes{
      {"a", Box(-2, -2, 0, 2, 2, 2)}, {"b", Box(-1, -1, 0, 3, 3, 3)}, {"c", Box(-2, -2, -1, 9, 9, 0)}};
  const RayScene scene(BoxWorld(boxes));
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d p_W = RandomPoint(random, 5);
    bool inside = false;
    for (const auto& [name, box] : boxes) inside |= box.contains(p_W);
    EXPECT_EQ(scene.Solid(p_W), inside) << p_W.transpose();
  }
}

TEST(RayScene, TakesABoxWithATriangleMissingOrTurnedForSolidAndOneWithoutALidForOpen) {
  World turned = BoxWorld({{"box", Box(-1, -1, -1, 1, 1, 1)}});
  std::swap(turned.mesh.triangles[3][0], turned.mesh.triangles[3][1]);
  EXPECT_TRUE(RayScene(turned).Solid({0.1, 0.2, 0}));
  EXPECT_FALSE(RayScene(turned).Solid({1.5, 0.2, 0}));
  World open = BoxWorld({{"box", Box(-1, -1, -1, 1, 1, 1)}});
  const auto is_lid = [&](const std::array<int, 3>& t) {
    return std::ranges::all_of(t, [&](int corner) { return open.mesh.vertices_W[corner].z() > 0.5f; });
  };
  std::erase_if(open.mesh.triangles, is_lid);
  open.parts.at(0).num_triangles = static_cast<int>(open.mesh.triangles.size());
  EXPECT_FALSE(RayScene(open).Solid({0.1, 0.2, 0.5}));
}

}  // namespace
}  // namespace citrine::sim

#include "fusion/brick_fuser.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "fusion/tsdf_integrator.h"
#include "tests/fusion/synthetic_tsdf.h"
#include "tests/support/analytic_scene.h"

namespace citrine::fusion {
namespace {

using test::AnalyticScene;

TEST(BrickFuser, CountsAFreeRayPastASurfaceVoxelAsALookAtIt) {
  AnalyticScene wall, with_bar;
  for (AnalyticScene* scene : {&wall, &with_bar}) scene->AddHalfSpace({-1, 0, 0}, -5.125);
  with_bar.AddBox({3.0, -0.2, 1}, {3.25, 0.4, 6});
  const Eigen::Vector3d on_bar(3.125, 0.125, 4.125), before_bar(1.125, 0.125, 4.125);
  for (const WeightPolicy policy : {WeightPolicy::kBestView, WeightPolicy::kPerScan}) {
    TsdfMap map(Grid(), kTruncation_m);
    TsdfIntegrator integrator(map, policy);
    integrator.Integrate(with_bar.Scan(At(-6, 0.125, 4.125)));
    const double from_afar = At(map, on_bar).quality;
    EXPECT_NEAR(from_afar, 1 / (9.0 * 9.0), 0.001);
    integrator.Integrate(wall.Scan(At(1, 0.125, 4.125)));  // all of its beams miss the bar
    const double expected = policy == WeightPolicy::kBestView ? 1 / (2.125 * 2.125) : from_afar;
    EXPECT_NEAR(At(map, on_bar).quality, expected, 0.001);
    EXPECT_EQ(At(map, before_bar).quality, 0);
  }
}

TEST(BrickFuser, TakesTheWordOfTheFirstThatSeeASurfaceWhereAllWasFree) {
  AnalyticScene far, near;
  far.AddHalfSpace({-1, 0, 0}, -8.1);
  near.AddHalfSpace({-1, 0, 0}, -5.2);  // 7.5 cm behind a layer of voxels
  TsdfMap map(Grid(), kTruncation_m);
  TsdfIntegrator integrator(map, WeightPolicy::kBestView);
  for (int k = 0; k < 5; ++k) integrator.Integrate(far.Scan(At(0, 0.125, 4.125)));
  const Eigen::Vector3d on_surface(5.125, 0.125, 4.125);
  EXPECT_FLOAT_EQ(At(map, on_surface).distance_m, kTruncation_m);
  integrator.Integrate(near.Scan(At(-4, 0.125, 4.125)));
  EXPECT_NEAR(At(map, on_surface).distance_m, 0.075, 0.01);
}

TEST(BrickFuser, KeepsWhatManyViewsHaveShownWhileHoveringBeforeIt) {
  AnalyticScene scene;
  scene.AddHalfSpace(Eigen::Vector3d::UnitZ(), 0.0);
  scene.AddBox({3, -2, 0}, {5, 2, 3});
  scene.AddBox({2.4, -2.5, 0}, {2.45, -2.45, 4});
  TsdfMap map(Grid(), kTruncation_m);
  TsdfIntegrator integrator(map, WeightPolicy::kBestView);
  Random random(1);
  LidarModel model;
  model.cols = 360;
  for (int i = 0; i < 60; ++i)
    integrator.Integrate(scene.Scan(
        At(4 + 5 * std::cos(0.3 * i), 5 * std::sin(0.3 * i), 2.5 + 0.02 * i, 0.05), model, 1.5e-4, &random));
  std::vector<VoxelIndex> surface;
  ForEachVoxel(map.grid(), [&](const VoxelIndex& v) {
    const Voxel voxel = At(map, v);
    if (voxel.known() && std::abs(voxel.distance_m) < kVoxel_m &&
        std::abs(scene.Distance(map.grid().Centre(v))) < 0.6 * kVoxel_m)
      surface.push_back(v);
  });
  ASSERT_GT(surface.size(), 1000u);
  for (int i = 0; i < 700; ++i)
    integrator.Integrate(scene.Scan(At(-1.5, 3.5, 2.5, 0.05), model, 1.5e-4, &random));
  const auto lost = std::count_if(surface.begin(), surface.end(), [&](const VoxelIndex& v) {
    return std::abs(At(map, v).distance_m) >= kVoxel_m;
  });
  EXPECT_LT(static_cast<double>(lost), 0.005 * static_cast<double>(surface.size()));
}

TEST(BrickFuser, LearnsFromNearerLooksWhatManyFromAfarHaveMistaken) {
  AnalyticScene mistaken, truth;
  mistaken.AddHalfSpace({-1, 0, 0}, -5.2);
  truth.AddHalfSpace({-1, 0, 0}, -5.1);
  TsdfMap map(Grid(), kTruncation_m);
  TsdfIntegrator integrator(map, WeightPolicy::kBestView);
  for (int k = 0; k < 200; ++k) integrator.Integrate(mistaken.Scan(At(-3.5, 0.125, 4.125)));
  for (int k = 0; k < 20; ++k) integrator.Integrate(truth.Scan(At(2, 0.125, 4.125)));
  EXPECT_NEAR(At(map, Eigen::Vector3d(5.125, 0.125, 4.125)).distance_m, -0.025, 0.015);
}

TEST(BrickFuser, SeesThroughWhatOneScanAloneHasShown) {
  AnalyticScene wall, with_thing;
  for (AnalyticScene* scene : {&wall, &with_thing}) scene->AddHalfSpace({-1, 0, 0}, -8.0);
  with_thing.AddSphere({3, 0, 4}, 0.6);
  TsdfMap map(Grid(), kTruncation_m);
  TsdfIntegrator integrator(map, WeightPolicy::kBestView);
  integrator.Integrate(with_thing.Scan(At(-5, 0.1, 4.1)));
  const auto occupied = [&] {
    int count = 0;
    ForEachVoxel(map.grid(), [&](const VoxelIndex& v) {
      const Voxel voxel = At(map, v);
      count += voxel.known() && voxel.distance_m < kVoxel_m && map.grid().Centre(v).x() < 5;
    });
    return count;
  };
  EXPECT_GT(occupied(), 30);
  for (int k = 0; k < 40; ++k) integrator.Integrate(wall.Scan(At(0.02 * k, 0.1, 4.1, 0.01 * k)));
  EXPECT_EQ(occupied(), 0);
}

}  // namespace
}  // namespace citrine::fusion

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/map/planning_map.h"
#include "fusion/map_fuser.h"
#include "tests/support/analytic_scene.h"

namespace citrine::fusion {
namespace {

using test::AnalyticScene;

constexpr double kVoxel_m = 0.25, kTruncation_m = 0.5;
const Eigen::AlignedBox3d kVolume_W{Eigen::Vector3d(-7, -7, 0), Eigen::Vector3d(7, 7, 5)};
const Eigen::AlignedBox3d kSeen_W{Eigen::Vector3d(-4, -4, 0.8), Eigen::Vector3d(4, 4, 4)};

MapFuser FuserOfAll() {
  return MapFuser(VoxelGrid(kVoxel_m, kVolume_W, kTruncation_m + kVoxel_m), kTruncation_m,
                  Quantisation(kTruncation_m, 1 / (4.5 * 4.5)), WeightPolicy::kBestView);
}

/// Sees a scene from three rings around its middle, with the paper's noise.
void SeeFromAround(const AnalyticScene& scene, double radius_m, MapFuser& fuser) {
  Random random(1);
  for (const double z : {1.5, 3.0, 4.5})
    for (int i = 0; i < 40; ++i) {
      const double at = i * EIGEN_PI / 20;
      const Eigen::Quaterniond q(Eigen::AngleAxisd(at + EIGEN_PI + 0.003 * i, Eigen::Vector3d::UnitZ()) *
                                 Eigen::AngleAxisd(0.06 * std::sin(i), Eigen::Vector3d::UnitX()));
      const Eigen::Vector3d p_WS(radius_m * std::cos(at), radius_m * std::sin(at), z);
      fuser.Integrate(scene.Scan({p_WS, q}, {}, 1.5e-4, &random));
    }
}

/// The map that decisions are made on.
PlanningMap SaidBy(MapFuser& fuser) {
  PlanningMap map(fuser.map().grid(), Quantisation(kTruncation_m, 1 / (4.5 * 4.5)));
  for (const int block : fuser.TakeChanged()) map.Apply(*fuser.Said(block));
  map.Update();
  return map;
}

/// By how much clearance is read too large, at random points of known free space.
struct Reading {
  double over_m = 0;
  int points = 0;
};
Reading ReadingOf(const AnalyticScene& scene, double radius_m) {
  MapFuser fuser = FuserOfAll();
  SeeFromAround(scene, radius_m, fuser);
  const PlanningMap map = SaidBy(fuser);
  Reading reading;
  Random random(2);
  for (int i = 0; i < 100'000; ++i) {
    const Eigen::Vector3d p_W(random.Uniform(kSeen_W.min().x(), kSeen_W.max().x()),
                              random.Uniform(kSeen_W.min().y(), kSeen_W.max().y()),
                              random.Uniform(kSeen_W.min().z(), kSeen_W.max().z()));
    const double truth_m = scene.Distance(p_W);
    const std::size_t voxel = map.grid().Linear(map.grid().IndexOf(p_W));
    if (truth_m < 0 || truth_m > PlanningMap::kOccupiedReach_m - kVoxel_m) continue;
    if (map.state(voxel) == VoxelState::kUnknown) continue;
    reading.over_m = std::max(reading.over_m, map.to_occupied().Interpolate(p_W) - truth_m);
    ++reading.points;
  }
  return reading;
}

TEST(Clearance, IsReadAtMostHalfAVoxelTooLargeBeforeGroundAndWalls) {
  // Besides half a voxel: half a step of the distance code, T/254.
  for (const double offset_m : {0.0, 0.04, 0.11, 0.19}) {
    AnalyticScene ground, wall;
    ground.AddHalfSpace(Eigen::Vector3d::UnitZ(), offset_m);
    wall.AddHalfSpace({-1, 0.3, 0.1}, -5 - offset_m);
    for (const AnalyticScene* scene : {&ground, &wall}) {
      const Reading reading = ReadingOf(*scene, 3.5);
      EXPECT_GT(reading.points, 5000);
      EXPECT_LE(reading.over_m, kVoxel_m / 2 + kTruncation_m / 254) << offset_m;
    }
  }
}

TEST(Clearance, IsReadAtMostHalfTheDiagonalOfAVoxelTooLargeAroundBoxesAndSpheres) {
  // At a convex edge the voxel that the surface passes may have its centre that far from the edge.
  for (const double offset_m : {0.0, 0.03, 0.06, 0.1}) {
    AnalyticScene box, sphere;
    box.AddBox(Eigen::Vector3d(-1.1, -0.9, -1).array() + offset_m,
               Eigen::Vector3d(0.9, 1.3, 2.5).array() + offset_m);
    sphere.AddSphere(Eigen::Vector3d(0, 0, 2.5).array() + offset_m, 1.2 - 2 * offset_m);
    for (const AnalyticScene* scene : {&box, &sphere}) {
      const Reading reading = ReadingOf(*scene, 4);
      EXPECT_GT(reading.points, 50000);
      EXPECT_LE(reading.over_m, std::sqrt(3.0) / 2 * kVoxel_m) << offset_m;
    }
  }
}

TEST(Clearance, KnowsBarsOfFiveCentimetresInOnePieceWhereverTheyStandBetweenVoxels) {
  for (const double at_m : {0.02, 0.07, 0.125, 0.17, 0.22}) {
    AnalyticScene scene;
    scene.AddBox({at_m - 0.025, at_m - 0.025, -1}, {at_m + 0.025, at_m + 0.025, 6});
    const Reading reading = ReadingOf(scene, 3);
    EXPECT_GT(reading.points, 30000);
    EXPECT_LE(reading.over_m, kVoxel_m / 2) << at_m;
  }
}

}  // namespace
}  // namespace citrine::fusion

#include <algorithm>
#include <cmath>
#include <vector>

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

/// Poses on five rings around the middle of the volume.
std::vector<Pose> PosesAround(double radius_m) {
  std::vector<Pose> poses;
  for (const double z : {0.5, 1.5, 3.0, 4.5, 6.0})
    for (int i = 0; i < 40; ++i) {
      const double at = i * EIGEN_PI / 20;
      const Eigen::Quaterniond q(Eigen::AngleAxisd(at + EIGEN_PI + 0.003 * i, Eigen::Vector3d::UnitZ()) *
                                 Eigen::AngleAxisd(0.06 * std::sin(i), Eigen::Vector3d::UnitX()));
      poses.push_back({{radius_m * std::cos(at), radius_m * std::sin(at), z}, q});
    }
  return poses;
}

/// The map that decisions are made on.
PlanningMap SaidBy(MapFuser& fuser) {
  PlanningMap map(fuser.map().grid(), Quantisation(kTruncation_m, 1 / (4.5 * 4.5)));
  for (const int block : fuser.TakeChanged()) map.Apply(*fuser.Said(block));
  map.Update();
  return map;
}

/// By how much clearance is read too large or small, at random points of known free space.
struct Reading {
  double over_m = 0, under_m = 0, mean_m = 0;
  int points = 0;
};
Reading ReadingOf(const AnalyticScene& scene, double radius_m) {
  MapFuser fuser = FuserOfAll();
  Random noise(1), random(2);
  for (const Pose& X_WS : PosesAround(radius_m)) fuser.Integrate(scene.Scan(X_WS, {}, 1.5e-4, &noise));
  const PlanningMap map = SaidBy(fuser);
  Reading reading;
  for (int i = 0; i < 100'000; ++i) {
    const Eigen::Vector3d p_W(random.Uniform(kSeen_W.min().x(), kSeen_W.max().x()),
                              random.Uniform(kSeen_W.min().y(), kSeen_W.max().y()),
                              random.Uniform(kSeen_W.min().z(), kSeen_W.max().z()));
    const double truth_m = scene.Distance(p_W);
    const std::size_t voxel = map.grid().Linear(map.grid().IndexOf(p_W));
    if (truth_m < 0 || truth_m > PlanningMap::kOccupiedReach_m - kVoxel_m) continue;
    if (map.state(voxel) == VoxelState::kUnknown) continue;
    const double error_m = map.to_occupied().Interpolate(p_W) - truth_m;
    reading.over_m = std::max(reading.over_m, error_m);
    reading.under_m = std::max(reading.under_m, -error_m);
    reading.mean_m += error_m;
    ++reading.points;
  }
  reading.mean_m /= std::max(reading.points, 1);
  return reading;
}

// Half a voxel, and half a step of the distance code.
constexpr double kHalf_m = kVoxel_m / 2 + kTruncation_m / 254;

TEST(Clearance, IsReadAtMostHalfAVoxelTooLargeAndAVoxelTooSmallBeforeGroundAndWalls) {
  for (const double offset_m : {0.0, 0.04, 0.11, 0.19}) {
    AnalyticScene ground, wall;
    ground.AddHalfSpace(Eigen::Vector3d::UnitZ(), offset_m);
    wall.AddHalfSpace({-1, 0.3, 0.1}, -5 - offset_m);
    for (const AnalyticScene* scene : {&ground, &wall}) {
      const Reading reading = ReadingOf(*scene, 3.5);
      EXPECT_GT(reading.points, 5000);
      EXPECT_LE(reading.over_m, kHalf_m) << offset_m;
      EXPECT_LE(reading.under_m, kVoxel_m) << offset_m;
    }
  }
}

TEST(Clearance, IsReadAtMostHalfAVoxelTooLargeAroundBoxesSpheresAndCylinders) {
  for (const double offset_m : {0.0, 0.03, 0.06, 0.1, 0.14, 0.19, 0.22}) {
    AnalyticScene box, turned_box, sphere, cylinder;
    box.AddBox(Eigen::Vector3d(-1.1, -0.9, -1).array() + offset_m,
               Eigen::Vector3d(0.9, 1.3, 2.5).array() + offset_m);
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.3 + 3 * offset_m, Eigen::Vector3d::UnitZ()) *
                                    Eigen::AngleAxisd(0.2 + offset_m, Eigen::Vector3d::UnitX()));
    turned_box.AddTurnedBox({1.1, 0.9, 1.2}, {{offset_m, -offset_m, 2 + offset_m}, turned});
    sphere.AddSphere(Eigen::Vector3d(0, 0, 3.2).array() + offset_m, 1.2 - 2 * offset_m);
    cylinder.AddCylinder({offset_m, -offset_m, -1}, 0.2 + 3 * offset_m, 3.5 + offset_m);
    for (const AnalyticScene* scene : {&box, &turned_box, &sphere, &cylinder}) {
      const Reading reading = ReadingOf(*scene, 4);
      EXPECT_GT(reading.points, 30000);
      EXPECT_LE(reading.over_m, kHalf_m) << offset_m;
      EXPECT_LE(reading.under_m, 1.5 * kVoxel_m) << offset_m;
      EXPECT_GE(reading.mean_m, -0.75 * kVoxel_m) << offset_m;
    }
  }
}

TEST(Clearance, KnowsBarsOfFiveCentimetresInOnePieceHoweverTheyStand) {
  for (const double at_m : {0.02, 0.07, 0.125, 0.17, 0.22}) {
    AnalyticScene upright, leaning;
    upright.AddBox({at_m - 0.025, at_m - 0.025, -1}, {at_m + 0.025, at_m + 0.025, 6});
    leaning.AddTurnedBox(
        {0.025, 0.025, 3.5},
        {{at_m, at_m, 2.5}, Eigen::Quaterniond(Eigen::AngleAxisd(0.2 + at_m, Eigen::Vector3d::UnitX()))});
    for (const AnalyticScene* scene : {&upright, &leaning}) {
      const Reading reading = ReadingOf(*scene, 3);
      EXPECT_GT(reading.points, 30000);
      EXPECT_LE(reading.over_m, kHalf_m) << at_m;
      // A bar is as thick as the voxels that it is seen in, and the caution comes on top.
      EXPECT_LE(reading.under_m, (1.65 + PlanningMap::kCaution_vox) * kVoxel_m) << at_m;
    }
  }
}

}  // namespace
}  // namespace citrine::fusion

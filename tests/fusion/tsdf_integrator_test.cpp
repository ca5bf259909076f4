#include "fusion/tsdf_integrator.h"

#include <cstring>

#include <gtest/gtest.h>

#include "tests/fusion/synthetic_tsdf.h"
#include "tests/support/analytic_scene.h"
#include "tests/support/ray_integrator.h"

namespace citrine::fusion {
namespace {

using test::AnalyticScene;

/// Largest and mean error of distance over the known voxels of a part of the band around the true surface.
struct Errors {
  double mean = 0, worst = 0;
  int count = 0;
};
Errors BandErrors(const TsdfMap& map, const AnalyticScene& scene, const Eigen::AlignedBox3d& part_W) {
  Errors errors;
  ForEachVoxel(map.grid(), [&](const VoxelIndex& v) {
    const Voxel voxel = At(map, v);
    const double truth = scene.Distance(map.grid().Centre(v));
    if (!voxel.known() || std::abs(truth) > 0.4 || !part_W.contains(map.grid().Centre(v))) return;
    const double error = std::abs(voxel.distance_m - truth);
    errors.worst = std::max(errors.worst, error);
    errors.mean += error;
    ++errors.count;
  });
  errors.mean /= std::max(errors.count, 1);
  return errors;
}

TEST(TsdfIntegrator, MeasuresAPlaneAlongItsNormalAtEveryIncidence) {
  AnalyticScene scene;
  scene.AddHalfSpace({-1, 0, 0}, -6.0);  // solid beyond x = 6
  TsdfMap map(Grid(), kTruncation_m);
  TsdfIntegrator(map, WeightPolicy::kBestView).Integrate(scene.Scan(At(0, 0, 4, 0.1, -0.05, 0.7)));
  // Within 9 m: beyond lie voxels before the plane whose beam meets it out of range.
  const Errors errors = BandErrors(map, scene, {Eigen::Vector3d(5, -6, 1), Eigen::Vector3d(7, 6, 7)});
  EXPECT_GT(errors.count, 2000);
  EXPECT_LT(errors.mean, 0.01);  // inverse range is linear on planes but for the curvature between two rings
  EXPECT_LT(errors.worst, 0.5 * kVoxel_m);
}

TEST(TsdfIntegrator, MeasuresASphereWithinATenthOfAVoxelOnAverage) {
  AnalyticScene scene;
  scene.AddSphere({0, 0, 4}, 2.0);
  TsdfMap map(Grid(), kTruncation_m);
  TsdfIntegrator integrator(map, WeightPolicy::kBestView);
  for (int i = 0; i < 12; ++i)
    integrator.Integrate(scene.Scan(At(6 * std::cos(i * EIGEN_PI / 6), 6 * std::sin(i * EIGEN_PI / 6), 4)));
  // Near the poles the sensors, all at the equator's height, only graze it.
  const Errors errors = BandErrors(map, scene, {Eigen::Vector3d(-3, -3, 3), Eigen::Vector3d(3, 3, 5)});
  EXPECT_GT(errors.count, 1000);
  EXPECT_LT(errors.mean, 0.1 * kVoxel_m);
}

TEST(TsdfIntegrator, AgreesWithTheExactRaysOnTheClassOfVoxels) {
  AnalyticScene scene;
  scene.AddHalfSpace(Eigen::Vector3d::UnitZ(), 0.0);
  scene.AddBox({3, -2, 0}, {5, 2, 3});
  scene.AddBox({-6, -5, 0}, {-5.7, 5, 4});
  scene.AddSphere({0, 5, 2}, 1.5);
  TsdfMap projective(Grid(), kTruncation_m), exact(Grid(), kTruncation_m);
  TsdfIntegrator integrator(projective, WeightPolicy::kBestView);
  test::RayIntegrator rays(exact);
  LidarModel dense;
  dense.rows = 128;
  dense.cols = 1024;
  for (int i = 0; i < 10; ++i) {
    const LidarScan scan = scene.Scan(At(-3 + 0.5 * i, -4 + 0.3 * i, 2.5, 0.05, 0.05, 0.3 * i), dense);
    integrator.Integrate(scan);
    rays.Integrate(scan);
  }
  // Away from edges and from the surface itself, where distance along the beam and along the normal differ by
  // intent.
  int both = 0, differ = 0;
  ForEachVoxel(projective.grid(), [&](const VoxelIndex& v) {
    const Voxel a = At(projective, v), b = At(exact, v);
    if (!a.known() || !b.known() || scene.Distance(projective.grid().Centre(v)) < 2 * kVoxel_m) return;
    ++both;
    differ += (a.distance_m > kVoxel_m) != (b.distance_m > kVoxel_m);
  });
  EXPECT_GT(both, 50000);
  EXPECT_LT(differ, 0.01 * both);
}

TEST(TsdfIntegrator, SumsWeightsOverScansAndKeepsTheBestSingleView) {
  AnalyticScene scene;
  scene.AddHalfSpace({-1, 0, 0}, -5.125);  // through the centres of a layer of voxels
  const Eigen::Vector3d on_surface(5.125, 0.125, 4.125);
  for (const WeightPolicy policy : {WeightPolicy::kBestView, WeightPolicy::kPerScan}) {
    TsdfMap map(Grid(), kTruncation_m);
    TsdfIntegrator integrator(map, policy);
    double sum = 0, best = 0;
    for (const double x : {-3.0, 1.0, 0.0, 2.0, -1.0}) {
      integrator.Integrate(scene.Scan(At(x, 0.125, 4.125)));
      const double w = 1 / ((5.125 - x) * (5.125 - x));
      sum += w;
      best = std::max(best, w);
    }
    const Voxel voxel = At(map, on_surface);
    EXPECT_NEAR(voxel.weight, sum, 0.01 * sum);  // interpolated range against the true one
    EXPECT_NEAR(voxel.quality, policy == WeightPolicy::kBestView ? best : sum, 0.005 * sum);
    EXPECT_NEAR(voxel.distance_m, 0, 0.01);
  }
}

TEST(TsdfIntegrator, CountsEveryPointUnderThePerPointPolicy) {
  AnalyticScene scene;
  scene.AddHalfSpace({-1, 0, 0}, -5.1);
  TsdfMap map(Grid(), kTruncation_m);
  const LidarScan scan = scene.Scan(At(0, 0, 4));
  TsdfIntegrator(map, WeightPolicy::kPerPoint).Integrate(scan);
  const VoxelIndex voxel = map.grid().IndexOf({5.1, 0.1, 4.1});
  double expected = 0;
  for (int row = 0; row < scan.model.rows; ++row)
    for (int col = 0; col < scan.model.cols; ++col) {
      const double r = scan.ranges_m[row * scan.model.cols + col];
      if (r > 0 && map.grid().IndexOf(scan.X_WS * (scan.model.Direction(row, col) * r)) == voxel)
        expected += 1 / (r * r);
    }
  ASSERT_GT(expected, 0);
  EXPECT_NEAR(At(map, voxel).quality, expected, 1e-5);
}

TEST(TsdfIntegrator, ReachesTheGoalExactlyWhenSeenFromWithinTheReferenceDistance) {
  AnalyticScene scene;
  scene.AddHalfSpace({-1, 0, 0}, -5.125);
  const double d_star = 4.5, w_star = 1 / (d_star * d_star);
  for (const double distance_m : {4.45, 4.55}) {
    TsdfMap map(Grid(), kTruncation_m);
    TsdfIntegrator integrator(map, WeightPolicy::kBestView);
    for (int k = 0; k < 20; ++k) integrator.Integrate(scene.Scan(At(5.125 - distance_m, 0.125, 4.125)));
    EXPECT_EQ(At(map, Eigen::Vector3d(5.125, 0.125, 4.125)).quality >= 0.9999 * w_star, distance_m < d_star);
  }
}

TEST(TsdfIntegrator, CarvesFreeSpaceAlongBeamsWithoutReturnUpToTheirRange) {
  TsdfMap map(Grid(), kTruncation_m);
  TsdfIntegrator(map, WeightPolicy::kBestView).Integrate(AnalyticScene().Scan(At(0, 0, 4)));
  for (const double x : {0.6, 3.1, 6.1, 9.6}) {
    const Voxel voxel = At(map, Eigen::Vector3d(x, 0.1, 4.1));
    EXPECT_TRUE(voxel.known()) << x;
    EXPECT_FLOAT_EQ(voxel.distance_m, kTruncation_m) << x;
    EXPECT_EQ(voxel.quality, 0) << x;
  }
  EXPECT_FALSE(At(map, Eigen::Vector3d(10.4, 0.1, 4.1)).known());
}

TEST(TsdfIntegrator, CarvesNothingAlongInvalidBeams) {
  LidarScan scan = AnalyticScene().Scan(At(0, 0, 4));
  std::fill(scan.ranges_m.begin(), scan.ranges_m.end(), kInvalid);
  TsdfMap map(Grid(), kTruncation_m);
  EXPECT_TRUE(TsdfIntegrator(map, WeightPolicy::kBestView).Integrate(scan).empty());
  for (int block = 0; block < map.grid().num_blocks(); ++block) EXPECT_EQ(map.Find(block), nullptr);
}

TEST(TsdfIntegrator, LeavesTheConesAboveAndBelowTheFieldOfViewUnknown) {
  TsdfMap map(Grid({-12, -12, -6}, {12, 12, 14}), kTruncation_m);
  TsdfIntegrator(map, WeightPolicy::kBestView).Integrate(AnalyticScene().Scan(At(0, 0, 4)));
  const LidarModel model;
  int outside = 0;
  ForEachVoxel(map.grid(), [&](const VoxelIndex& v) {
    const Eigen::Vector3d p = map.grid().Centre(v) - Eigen::Vector3d(0, 0, 4);
    const double elevation = std::atan2(p.z(), p.head<2>().norm());
    const double half_ring = model.row_step_rad() / 2 + 1e-3;
    if (elevation < model.elevation_max_rad + half_ring && elevation > model.elevation_min_rad - half_ring)
      return;
    ++outside;
    EXPECT_FALSE(At(map, v).known()) << p.transpose();
  });
  EXPECT_GT(outside, 1000);
}

TEST(TsdfIntegrator, KeepsTheSurfaceOfAThinBarThatManyBeamsMiss) {
  AnalyticScene scene;
  scene.AddBox({2.10, 0.10, 1}, {2.15, 0.15, 6});  // a pole, 5 cm
  scene.AddHalfSpace({-1, 0, 0}, -5.0);            // a wall behind it
  TsdfMap map(Grid(), kTruncation_m);
  TsdfIntegrator integrator(map, WeightPolicy::kBestView);
  for (int i = 0; i < 40; ++i)
    integrator.Integrate(scene.Scan(At(-1.5, -2 + 0.1 * i, 4, 0.02, 0, 0.013 * i)));
  // From 8 m nearly every beam misses it; that must not erase what was seen from nearby.
  for (int i = 0; i < 40; ++i) integrator.Integrate(scene.Scan(At(-5, -2 + 0.1 * i, 4, 0.02, 0, 0.017 * i)));
  int kept = 0;
  for (double z = 3.125; z < 5; z += kVoxel_m) {
    bool any = false;
    for (const double x : {2.125, 1.875})
      for (const double y : {0.125, -0.125, 0.375}) {
        const Voxel voxel = At(map, Eigen::Vector3d(x, y, z));
        any |= voxel.known() && voxel.distance_m < kVoxel_m;
      }
    kept += any;
  }
  EXPECT_EQ(kept, 8);
}

TEST(TsdfIntegrator, KnowsTheGroundSeenAtAGrazingAngleWithoutGapsOrPhantoms) {
  AnalyticScene scene;
  scene.AddHalfSpace(Eigen::Vector3d::UnitZ(), 0.0);
  TsdfMap map(Grid({-15, -15, 0}, {15, 15, 5}), kTruncation_m);
  TsdfIntegrator integrator(map, WeightPolicy::kBestView);
  Random random(1);
  for (int i = 0; i < 10; ++i)
    integrator.Integrate(
        scene.Scan(At(0.1 * i, 0, 2.5, 0.05 * std::sin(i), 0.05 * std::cos(i)), {}, 1.5e-4, &random));
  int ground = 0, occupied = 0, above = 0, free_above = 0, phantoms = 0;
  ForEachVoxel(map.grid(), [&](const VoxelIndex& v) {
    const Eigen::Vector3d p = map.grid().Centre(v);
    const double radius = p.head<2>().norm();
    if (!map.grid().Inside(v) || radius < 4.5 || radius > 7.5) return;
    const Voxel voxel = At(map, v);
    if (std::abs(p.z() - 0.125) < 1e-6) {
      ++ground;
      occupied += voxel.known() && voxel.distance_m < kVoxel_m;
    } else if (p.z() < 1.5) {
      ++above;
      free_above += voxel.known() && voxel.distance_m > kVoxel_m;
      phantoms += voxel.known() && voxel.distance_m < kVoxel_m;
    }
  });
  EXPECT_GT(ground, 1500);
  EXPECT_GT(occupied, 0.99 * ground);
  EXPECT_GT(free_above, 0.995 * above);
  EXPECT_EQ(phantoms, 0);
}

TEST(TsdfIntegrator, MakesNoPhantomsBeyondTheEdgesOfABox) {
  AnalyticScene scene;
  scene.AddHalfSpace(Eigen::Vector3d::UnitZ(), 0.0);
  scene.AddBox({3, -2, 0}, {6, 2, 2});
  TsdfMap map(Grid(), kTruncation_m);
  TsdfIntegrator integrator(map, WeightPolicy::kBestView);
  Random random(2);
  for (int i = 0; i < 30; ++i)
    integrator.Integrate(scene.Scan(At(-2 + 0.1 * i, -3 + 0.2 * i, 3, 0.05 * std::sin(i), 0.03, 0.1 * i), {},
                                    1.5e-4, &random));
  int phantoms = 0;
  ForEachVoxel(map.grid(), [&](const VoxelIndex& v) {
    const Voxel voxel = At(map, v);
    if (voxel.known() && voxel.distance_m < kVoxel_m / 2 &&
        scene.Distance(map.grid().Centre(v)) > 1.5 * kVoxel_m)
      ++phantoms;
  });
  EXPECT_EQ(phantoms, 0);
}

TEST(TsdfIntegrator, ContinuesNoFaceOfABoxBeyondItsEdges) {
  AnalyticScene scene;
  scene.AddBox({-1.07, -0.87, -0.97}, {0.93, 1.33, 2.53});
  TsdfMap map(Grid(), kTruncation_m);
  TsdfIntegrator integrator(map, WeightPolicy::kBestView);
  Random random(1);
  for (const double z : {1.5, 3.0, 4.5})
    for (int i = 0; i < 40; ++i) {
      const double at = i * EIGEN_PI / 20;
      integrator.Integrate(scene.Scan(
          At(4 * std::cos(at), 4 * std::sin(at), z, 0.06 * std::sin(i), 0, at + 3.14), {}, 1.5e-4, &random));
    }
  int phantoms = 0;
  ForEachVoxel(map.grid(), [&](const VoxelIndex& v) {
    const Voxel voxel = At(map, v);
    phantoms +=
        voxel.known() && voxel.distance_m < kVoxel_m && scene.Distance(map.grid().Centre(v)) > 1.5 * kVoxel_m;
  });
  EXPECT_EQ(phantoms, 0);
}

TEST(TsdfIntegrator, IsTheSameBitForBitWhenRepeatedAndForAnyNumberOfThreads) {
  AnalyticScene scene;
  scene.AddHalfSpace(Eigen::Vector3d::UnitZ(), 0.0);
  scene.AddSphere({0, 0, 4}, 2.0);
  TsdfMap once(Grid(), kTruncation_m);
  TsdfIntegrator first(once, WeightPolicy::kPerScan);
  std::vector<std::vector<int>> changed;
  for (int i = 0; i < 3; ++i) changed.push_back(first.Integrate(scene.Scan(At(-6, i, 4))));
  for (const int threads : {1, 2, 3, 8}) {
    TsdfMap again(Grid(), kTruncation_m);
    TsdfIntegrator integrator(again, WeightPolicy::kPerScan, threads);
    for (int i = 0; i < 3; ++i) EXPECT_EQ(integrator.Integrate(scene.Scan(At(-6, i, 4))), changed[i]);
    for (int block = 0; block < once.grid().num_blocks(); ++block) {
      ASSERT_EQ(once.Find(block) == nullptr, again.Find(block) == nullptr);
      if (!once.Find(block)) continue;
      EXPECT_EQ(std::memcmp(once.Find(block), again.Find(block), sizeof(TsdfBlock)), 0) << threads;
    }
  }
}

}  // namespace
}  // namespace citrine::fusion

#include <array>
#include <cstring>

#include <gtest/gtest.h>

#include "fusion/tsdf_integrator.h"
#include "tests/support/analytic_scene.h"
#include "tests/support/voxel_integrator.h"

namespace citrine::fusion {
namespace {

using test::AnalyticScene;

const Eigen::AlignedBox3d kVolume_W{Eigen::Vector3d(-9, -9, 0), Eigen::Vector3d(9, 9, 8)};

/// Ground, walls near and as far as the range, blocks before them, corners, balls and bars of 5 cm.
AnalyticScene RandomScene(Random& random) {
  const auto within = [&](double x, double y, double low, double high) {
    return Eigen::Vector3d(random.Uniform(-x, x), random.Uniform(-y, y), random.Uniform(low, high));
  };
  AnalyticScene scene;
  if (random.Below(4) > 0)
    scene.AddHalfSpace({random.Uniform(-0.2, 0.2), random.Uniform(-0.2, 0.2), 1}, random.Uniform(-0.3, 0.3));
  for (int i = static_cast<int>(random.Below(3)); i > 0; --i)
    scene.AddHalfSpace(within(1, 1, -0.3, 0.3), -random.Uniform(4, 10.5));
  for (int i = static_cast<int>(random.Below(6)); i > 0; --i) {
    const Eigen::Vector3d at = within(8, 8, 0, 6);
    scene.AddBox(at, at + within(3, 3, 0.1, 4).cwiseAbs());
  }
  for (int i = static_cast<int>(random.Below(6)); i > 0; --i) {
    const Eigen::Vector3d at = within(7, 7, 0, 5);
    Eigen::Vector3d size = Eigen::Vector3d::Constant(0.05);
    size[static_cast<int>(random.Below(3))] = random.Uniform(1, 6);
    scene.AddBox(at, at + size);
  }
  for (int i = static_cast<int>(random.Below(3)); i > 0; --i)
    scene.AddSphere(within(7, 7, 0, 6), random.Uniform(0.2, 2));
  return scene;
}

LidarScan RandomScan(const AnalyticScene& scene, const LidarModel& model, Random& random) {
  Eigen::Vector3d p_WS(random.Uniform(-7, 7), random.Uniform(-7, 7), random.Uniform(0.5, 7));
  for (int i = 0; i < 50 && scene.Distance(p_WS) < 0.3; ++i)
    p_WS = {random.Uniform(-7, 7), random.Uniform(-7, 7), random.Uniform(0.5, 7)};
  const Eigen::Quaterniond q_WS(
      Eigen::AngleAxisd(random.Uniform(-EIGEN_PI, EIGEN_PI), Eigen::Vector3d::UnitZ()) *
      Eigen::AngleAxisd(random.Uniform(-0.4, 0.4), Eigen::Vector3d::UnitY()) *
      Eigen::AngleAxisd(random.Uniform(-0.4, 0.4), Eigen::Vector3d::UnitX()));
  LidarScan scan = scene.Scan({p_WS, q_WS}, model, random.Below(3) * 1.5e-4, &random);
  if (random.Below(3) == 0)
    for (float& range_m : scan.ranges_m)
      if (random.Below(100) == 0) range_m = kInvalid;
  return scan;
}

/// Blocks that differ in a bit of anything.
int Differing(const TsdfMap& a, const TsdfMap& b) {
  int differing = 0;
  for (int block = 0; block < a.grid().num_blocks(); ++block) {
    const TsdfBlock *one = a.Find(block), *other = b.Find(block);
    if (!one && !other) continue;
    differing += !one || !other || std::memcmp(one, other, sizeof(TsdfBlock)) != 0;
  }
  return differing;
}

TEST(Skipping, LeavesTheMapThatLookingUpEveryVoxelMakes) {
  Random random(1);
  for (int k = 0; k < 80; ++k) {
    const AnalyticScene scene = RandomScene(random);
    LidarModel model;
    model.rows = std::array{1, 2, 16, 32, 64}[random.Below(5)];
    model.cols = std::array{180, 360, 512, 720}[random.Below(4)];
    const double voxel_m = std::array{0.25, 0.25, 0.4}[random.Below(3)],
                 truncation_m = voxel_m * std::array{2, 3}[random.Below(2)];
    const WeightPolicy policy = random.Below(2) ? WeightPolicy::kBestView : WeightPolicy::kPerScan;
    const VoxelGrid grid(voxel_m, kVolume_W, truncation_m + voxel_m);
    TsdfMap skipping(grid, truncation_m), looking(grid, truncation_m);
    TsdfIntegrator integrator(skipping, policy);
    test::VoxelIntegrator every_voxel(looking, policy);
    for (int i = 0; i < 6; ++i) {
      const LidarScan scan = RandomScan(scene, model, random);
      EXPECT_EQ(integrator.Integrate(scan), every_voxel.Integrate(scan)) << "scene " << k << ", scan " << i;
      EXPECT_EQ(Differing(skipping, looking), 0) << "scene " << k << ", scan " << i;
    }
  }
}

}  // namespace
}  // namespace citrine::fusion

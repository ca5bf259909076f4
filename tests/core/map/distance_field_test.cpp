#include "core/map/distance_field.h"

#include <gtest/gtest.h>

#include "core/map/dirty_boxes.h"
#include "core/random.h"

namespace citrine {
namespace {

VoxelGrid SmallGrid() { return VoxelGrid(0.5, {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(17, 9, 11)}, 0.5); }

std::vector<std::uint16_t> BruteForce(const VoxelGrid& grid, const std::vector<std::uint8_t>& is_site,
                                      int radius) {
  std::vector<VoxelIndex> sites;
  for (std::size_t i = 0; i < is_site.size(); ++i)
    if (is_site[i]) sites.push_back(grid.FromLinear(i));
  std::vector<std::uint16_t> squared(grid.num_voxels());
  for (std::size_t i = 0; i < squared.size(); ++i) {
    int nearest = radius * radius;
    for (const VoxelIndex& site : sites)
      nearest = std::min(nearest, (site - grid.FromLinear(i)).squaredNorm());
    squared[i] = static_cast<std::uint16_t>(nearest);
  }
  return squared;
}

void ExpectEqual(const DistanceField& field, const std::vector<std::uint16_t>& expected) {
  int differ = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) differ += field.squared_vox(i) != expected[i];
  EXPECT_EQ(differ, 0);
}

TEST(DistanceField, EqualsBruteForceWhenComputedWhole) {
  const VoxelGrid grid = SmallGrid();
  for (const int radius : {1, 3, 7, 12}) {
    Random random(radius);
    std::vector<std::uint8_t> is_site(grid.num_voxels());
    for (auto& site : is_site) site = random.Uniform() < 0.003;
    DistanceField field(grid, radius);
    field.Update(is_site, VoxelIndex::Zero(), grid.voxels());
    ExpectEqual(field, BruteForce(grid, is_site, radius));
  }
}

TEST(DistanceField, IsNeverCertainlyBeyondMoreThanItInterpolatesTo) {
  const VoxelGrid grid = SmallGrid();
  Random random(8);
  std::vector<std::uint8_t> is_site(grid.num_voxels());
  for (auto& site : is_site) site = random.Uniform() < 0.002;
  DistanceField field(grid, 8);
  field.Update(is_site, VoxelIndex::Zero(), grid.voxels());
  int certain = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Eigen::Vector3d p_W(random.Uniform(-1, 18), random.Uniform(-1, 10), random.Uniform(-1, 12));
    const double asked_m = random.Uniform(0.2, 4);
    if (!field.CertainlyBeyond(p_W, asked_m)) continue;
    ++certain;
    ASSERT_GE(field.Interpolate(p_W), asked_m - 1e-5) << p_W.transpose();  // distances are kept as floats
  }
  EXPECT_GT(certain, 1000);
}

TEST(DistanceField, EqualsBruteForceAfterSitesCameAndWentInBoxes) {
  const VoxelGrid grid = SmallGrid();
  Random random(5);
  std::vector<std::uint8_t> is_site(grid.num_voxels(), 0);
  DistanceField field(grid, 6);
  for (int round = 0; round < 12; ++round) {
    const VoxelIndex min(random.Below(30), random.Below(16), random.Below(18));
    const VoxelIndex max = (min.array() + 1 + static_cast<int>(random.Below(8))).min(grid.voxels().array());
    for (int z = min.z(); z < max.z(); ++z)
      for (int y = min.y(); y < max.y(); ++y)
        for (int x = min.x(); x < max.x(); ++x) is_site[grid.Linear({x, y, z})] = random.Uniform() < 0.05;
    field.Update(is_site, min, max);
    ExpectEqual(field, BruteForce(grid, is_site, 6));
  }
}

TEST(DistanceField, InterpolatesTheValuesAtVoxelCentresAndTheirSlopeBetweenThem) {
  const VoxelGrid grid = SmallGrid();
  std::vector<std::uint8_t> is_site(grid.num_voxels(), 0);
  is_site[grid.Linear({10, 8, 9})] = is_site[grid.Linear({20, 12, 4})] = 1;
  DistanceField field(grid, 12);
  field.Update(is_site, VoxelIndex::Zero(), grid.voxels());
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const VoxelIndex v(random.Below(grid.voxels().x()), random.Below(grid.voxels().y()),
                       random.Below(grid.voxels().z()));
    EXPECT_NEAR(field.Interpolate(grid.Centre(v)), field.At(grid.Linear(v)), 1e-6);
    const Eigen::Vector3d p =
        grid.Centre(VoxelIndex(5, 5, 5)) +
        Eigen::Vector3d(random.Uniform(0, 8), random.Uniform(0, 3), random.Uniform(0, 4));
    Eigen::Vector3d gradient;
    field.Interpolate(p, &gradient);
    const double h = 1e-6;
    const Eigen::Vector3d in_cell = (p - grid.origin_W()) / grid.voxel_m() - Eigen::Vector3d::Constant(0.5);
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(in_cell[axis] - std::round(in_cell[axis])) < 1e-4) continue;  // a kink of the interpolant
      const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(axis);
      const double slope = (field.Interpolate(p + step) - field.Interpolate(p - step)) / (2 * h);
      EXPECT_NEAR(gradient[axis], slope, 1e-5);
    }
  }
}

TEST(DistanceField, ReadsTheNearestVoxelOutsideTheGrid) {
  const VoxelGrid grid = SmallGrid();
  std::vector<std::uint8_t> is_site(grid.num_voxels(), 0);
  is_site[grid.Linear({0, 3, 3})] = 1;
  DistanceField field(grid, 5);
  field.Update(is_site, VoxelIndex::Zero(), grid.voxels());
  Eigen::Vector3d gradient;
  EXPECT_NEAR(field.Interpolate(grid.Centre({0, 3, 3}) - Eigen::Vector3d(9, 0, 0), &gradient), 0, 1e-9);
  EXPECT_EQ(gradient.x(), 0);
}

TEST(DistanceField, TakesItsCautionOffWhateverIsReadAndLeavesSlopesAsTheyAre) {
  const VoxelGrid grid = SmallGrid();
  std::vector<std::uint8_t> is_site(grid.num_voxels(), 0);
  is_site[grid.Linear({10, 8, 9})] = is_site[grid.Linear({20, 12, 4})] = 1;
  DistanceField plain(grid, 6), cautious(grid, 6, 0.2);
  for (DistanceField* field : {&plain, &cautious}) field->Update(is_site, VoxelIndex::Zero(), grid.voxels());
  EXPECT_DOUBLE_EQ(cautious.radius_m(), plain.radius_m() - 0.2);
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d p(random.Uniform(-1, 18), random.Uniform(-1, 10), random.Uniform(-1, 12));
    Eigen::Vector3d slope, cautious_slope;
    const double distance_m = plain.Interpolate(p, &slope);
    EXPECT_NEAR(cautious.Interpolate(p, &cautious_slope), distance_m - 0.2, 1e-6);  // floats inside
    EXPECT_LE((cautious_slope - slope).norm(), 1e-6);
  }
}

TEST(DirtyBoxes, HoldEveryBlockAndKeepFarGroupsApart) {
  const VoxelGrid grid(0.25, {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(40, 40, 10)}, 0);
  std::vector<int> blocks;
  for (const VoxelIndex& v :
       {VoxelIndex(0, 0, 0), VoxelIndex(8, 8, 0), VoxelIndex(144, 136, 8), VoxelIndex(152, 144, 8)})
    blocks.push_back(grid.Block(v));
  const std::vector<DirtyBox> boxes = DirtyBoxes(grid, blocks, 24);
  ASSERT_EQ(boxes.size(), 2u);
  for (const int block : blocks) {
    int holding = 0;
    for (const DirtyBox& box : boxes) {
      const VoxelIndex v = grid.BlockOrigin(block);
      holding += (v.array() >= box.min.array()).all() && ((v.array() + kBlockSide) <= box.max.array()).all();
      EXPECT_LE((box.max - box.min).maxCoeff(), 16);
    }
    EXPECT_EQ(holding, 1);
  }
}

}  // namespace
}  // namespace citrine

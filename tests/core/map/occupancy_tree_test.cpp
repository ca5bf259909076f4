#include "core/map/occupancy_tree.h"

#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include "core/random.h"

namespace citrine {
namespace {

using Leaf = OccupancyTree::Leaf;

VoxelGrid Grid(double voxel_m, const Eigen::Vector3d& min_W) {
  const Eigen::Vector3d size = Eigen::Vector3d(40, 28, 36) * voxel_m;
  return VoxelGrid(voxel_m, {min_W, min_W + size}, 2 * voxel_m);
}

/// Volumes on all sides of the origin and on one, that begin at any place of an octree's cubes of leaves.
std::vector<VoxelGrid> Grids() {
  // Centres lie on borders of leaves in the last three; in the last one only as single precision rounds.
  const double below = 1e-4 * 0.25 + 1e-9;
  return {Grid(0.25, {-6, -4, -2}),
          Grid(0.25, {-5.5, -3.25, 0.75}),
          Grid(0.5, {-25.5, -47, -91.5}),
          Grid(0.1, {4.3, 3.7, 0.9}),
          Grid(0.25, {0.125, -2.875, -5.125}),
          Grid(0.3, {-4.95, 40.65, -0.15}),
          Grid(0.25, {7.125 - below, 4.875 - below, 1.375 - below})};
}

Quantisation Codes(const VoxelGrid& grid) { return {2 * grid.voxel_m(), 1 / (4.5 * 4.5)}; }

/// All free, all occupied, or both and now and then unknown.
MapBlock RandomBlock(int index, Random& random, std::uint32_t version) {
  MapBlock block;
  block.index = index;
  block.version = version;
  const double all = random.Uniform();
  for (std::uint8_t& code : block.distance)
    code = all < 0.3   ? kFreeCode
           : all < 0.5 ? 1
                       : static_cast<std::uint8_t>(random.Uniform() < 0.3 ? 0 : random.Below(256));
  return block;
}

/// OctoMap's own tree of the same voxels, set one after the other.
class OctoMapsOwn {
 public:
  explicit OctoMapsOwn(const VoxelGrid& grid) : grid_(grid), tree_(grid.voxel_m()) {}

  octomap::point3d Point(const VoxelIndex& voxel) const {
    // Centres may lie on leaves' borders: such a voxel belongs to the leaf above.
    const Eigen::Vector3f p_W = (grid_.Centre(voxel).array() + 1e-4 * grid_.voxel_m()).matrix().cast<float>();
    return {p_W.x(), p_W.y(), p_W.z()};
  }
  void Set(const VoxelIndex& voxel, bool occupied) {
    tree_.setNodeValue(Point(voxel),
                       occupied ? tree_.getClampingThresMaxLog() : tree_.getClampingThresMinLog(), true);
  }
  void Set(const PlanningMap& map) {
    for (std::size_t i = 0; i < grid_.num_voxels(); ++i)
      if (map.state(i) != VoxelState::kUnknown)
        Set(grid_.FromLinear(i), map.distance_m(i) < grid_.voxel_m() / 2);
  }
  std::string Bytes() {
    tree_.updateInnerOccupancy();
    std::ostringstream stream;
    tree_.writeBinary(stream);  // prunes it first
    return stream.str();
  }
  Leaf At(const VoxelIndex& voxel) const {
    const octomap::OcTreeNode* node = tree_.search(Point(voxel));
    if (!node) return Leaf::kUnknown;
    return tree_.isNodeOccupied(node) ? Leaf::kOccupied : Leaf::kFree;
  }
  const octomap::OcTree& tree() const { return tree_; }

 private:
  VoxelGrid grid_;
  octomap::OcTree tree_;
};

std::string Text(const OccupancyTree& tree) {
  const std::vector<std::uint8_t> bytes = tree.Bytes();
  return {bytes.begin(), bytes.end()};
}

TEST(OccupancyTree, IsWrittenAsOctoMapWritesTheSameVoxelsHoweverTheMapChanges) {
  Random random(6);
  for (const VoxelGrid& grid : Grids()) {
    PlanningMap map(grid, Codes(grid));
    OctoMapsOwn expected(grid);
    OccupancyTree tree;
    for (std::uint32_t version = 1; version <= 8; ++version) {
      for (int k = 0; k < 25; ++k)
        map.Apply(RandomBlock(static_cast<int>(random.Below(grid.num_blocks())), random, version));
      map.Update();
      tree.Update(map);
      expected.Set(map);
      ASSERT_TRUE(Text(tree) == expected.Bytes()) << grid.origin_W().transpose() << ", version " << version;
    }
    for (std::size_t i = 0; i < grid.num_voxels(); ++i) {
      const octomap::point3d p_W = expected.Point(grid.FromLinear(i));
      ASSERT_EQ(tree.At({p_W.x(), p_W.y(), p_W.z()}), expected.At(grid.FromLinear(i)));
    }
  }
}

TEST(OccupancyTree, PrunesWholeRegionsAndOpensThemAgainAsOctoMapDoes) {
  Random random(7);
  for (const VoxelGrid& grid : Grids()) {
    PlanningMap map(grid, Codes(grid));
    OctoMapsOwn expected(grid);
    OccupancyTree tree;
    std::uint32_t version = 0;
    for (const std::uint8_t code : {kFreeCode, std::uint8_t{1}, kFreeCode}) {
      ++version;
      for (MapBlock block{.index = 0, .version = version}; block.index < grid.num_blocks(); ++block.index) {
        block.distance.fill(code);
        map.Apply(block);
      }
      tree.Update(map);
      expected.Set(map);
      ASSERT_TRUE(Text(tree) == expected.Bytes()) << grid.origin_W().transpose();
      // A leaf as large as 16 voxels means that a cube of cubes was pruned.
      double largest_m = 0;
      for (auto leaf = expected.tree().begin_leafs(); leaf != expected.tree().end_leafs(); ++leaf)
        largest_m = std::max(largest_m, leaf.getSize());
      ASSERT_GT(largest_m, 15.5 * grid.voxel_m());
      map.Apply(RandomBlock(static_cast<int>(random.Below(grid.num_blocks())), random, ++version));
      tree.Update(map);
      expected.Set(map);
      ASSERT_TRUE(Text(tree) == expected.Bytes()) << grid.origin_W().transpose();
    }
  }
}

TEST(OccupancyTree, KeepsWhatItHeldWhereTheMapForgets) {
  const VoxelGrid grid = Grids().front();
  PlanningMap map(grid, Codes(grid));
  OccupancyTree tree;
  for (const std::uint8_t code : {std::uint8_t{1}, kUnknownCode}) {
    MapBlock block{.index = 3, .version = code == kUnknownCode ? 2u : 1u};
    block.distance.fill(code);
    ASSERT_TRUE(map.Apply(block));
    tree.Update(map);
    EXPECT_EQ(tree.At(grid.Centre(grid.BlockOrigin(3))), Leaf::kOccupied);
  }
}

TEST(OccupancyTree, OfAFullMapIsWrittenAsOctoMapWritesIt) {
  Random random(8);
  for (const VoxelGrid& grid : Grids()) {
    TsdfMap map(grid, 2 * grid.voxel_m());
    OctoMapsOwn expected(grid);
    for (int block = 0; block < grid.num_blocks(); block += 1 + static_cast<int>(random.Below(3))) {
      TsdfBlock& full = map.Allocate(block);
      const double known = random.Uniform() < 0.5 ? 0.6 : 1, free = random.Uniform() < 0.5 ? 0.8 : 1;
      for (int i = 0; i < kBlockVoxels; ++i) {
        const VoxelIndex in_block(i % 8, i / 8 % 8, i / 64);
        const int at = TsdfBlock::IndexOf(in_block);
        if (random.Uniform() >= known) continue;
        full.weight[at] = 1;
        full.distance_m[at] = static_cast<float>((random.Uniform() < free ? 0.51 : 0.49) * grid.voxel_m());
        expected.Set(grid.BlockOrigin(block) + in_block, full.distance_m[at] < grid.voxel_m() / 2);
      }
    }
    OccupancyTree tree;
    tree.Add(map);
    ASSERT_TRUE(Text(tree) == expected.Bytes()) << grid.origin_W().transpose();
  }
}

TEST(OccupancyTree, OfAnEmptyMapIsAnEmptyOctree) {
  const VoxelGrid grid = Grids().front();
  OccupancyTree tree;
  EXPECT_EQ(Text(tree), OctoMapsOwn(Grid(1, {0, 0, 0})).Bytes());
  tree.Update(PlanningMap(grid, Codes(grid)));
  EXPECT_EQ(Text(tree), OctoMapsOwn(grid).Bytes());
  EXPECT_EQ(tree.At(grid.Centre({0, 0, 0})), Leaf::kUnknown);
}

TEST(OccupancyTree, KnowsNothingBeyondTheMap) {
  const VoxelGrid grid = Grids().front();
  PlanningMap map(grid, Codes(grid));
  for (MapBlock block{.index = 0, .version = 1}; block.index < grid.num_blocks(); ++block.index) {
    block.distance.fill(kFreeCode);
    map.Apply(block);
  }
  OccupancyTree tree;
  tree.Update(map);
  const VoxelIndex first = VoxelIndex::Zero(), last = grid.voxels().array() - 1;
  EXPECT_EQ(tree.At(grid.Centre(first)), Leaf::kFree);
  EXPECT_EQ(tree.At(grid.Centre(last)), Leaf::kFree);
  for (int axis = 0; axis < 3; ++axis) {
    for (const int far : {1, 10, 1000, 100'000}) {
      EXPECT_EQ(tree.At(grid.Centre(first - far * VoxelIndex::Unit(axis))), Leaf::kUnknown);
      EXPECT_EQ(tree.At(grid.Centre(last + far * VoxelIndex::Unit(axis))), Leaf::kUnknown);
    }
  }
}

TEST(OccupancyTree, IsReadByOctoMap) {
  const VoxelGrid grid = Grids().front();
  PlanningMap map(grid, Codes(grid));
  Random random(9);
  for (int block = 0; block < grid.num_blocks(); block += 2) map.Apply(RandomBlock(block, random, 1));
  OccupancyTree tree;
  tree.Update(map);
  std::istringstream stream(Text(tree));
  octomap::OcTree read(1.0);
  ASSERT_TRUE(read.readBinary(stream));
  EXPECT_EQ(read.getResolution(), 0.25);
  for (std::size_t i = 0; i < grid.num_voxels(); i += 7) {
    const Eigen::Vector3d p_W = grid.Centre(grid.FromLinear(i));
    const octomap::OcTreeNode* node = read.search(p_W.x(), p_W.y(), p_W.z());
    const Leaf expected = map.state(i) == VoxelState::kUnknown ? Leaf::kUnknown
                          : map.distance_m(i) < 0.125          ? Leaf::kOccupied
                                                               : Leaf::kFree;
    ASSERT_EQ(tree.At(p_W), expected);
    ASSERT_EQ(node != nullptr, expected != Leaf::kUnknown);
    if (node) {
      ASSERT_EQ(read.isNodeOccupied(node), expected == Leaf::kOccupied);
    }
  }
}

}  // namespace
}  // namespace citrine

#include "core/map/occupancy_tree.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include <octomap/OcTree.h>

namespace citrine {

struct OccupancyTree::Impl {
  explicit Impl(double voxel_m) : tree(voxel_m) {}
  /// Sets a leaf; the nodes above follow in Settle().
  void Set(const VoxelGrid& grid, const VoxelIndex& voxel, Leaf leaf_is);
  void Settle() {
    tree.updateInnerOccupancy();
    tree.prune();
  }

  octomap::OcTree tree;
  std::vector<std::uint32_t> version;  ///< of the blocks as last looked at
  std::vector<std::uint8_t> leaf;      ///< as in the tree: Leaf
};

OccupancyTree::OccupancyTree() = default;
OccupancyTree::~OccupancyTree() = default;

void OccupancyTree::Impl::Set(const VoxelGrid& grid, const VoxelIndex& voxel, Leaf leaf_is) {
  // A hair off the centre, so that rounding never puts two voxels into one leaf.
  const Eigen::Vector3f p_W =
      (grid.Centre(voxel) + Eigen::Vector3d::Constant(1e-4 * grid.voxel_m())).cast<float>();
  const bool occupied = leaf_is == Leaf::kOccupied;
  tree.setNodeValue(octomap::point3d(p_W.x(), p_W.y(), p_W.z()),
                    occupied ? tree.getClampingThresMaxLog() : tree.getClampingThresMinLog(), true);
}

void OccupancyTree::Add(const TsdfMap& map) {
  const VoxelGrid& grid = map.grid();
  if (!impl_) impl_ = std::make_unique<Impl>(grid.voxel_m());
  for (int block = 0; block < grid.num_blocks(); ++block) {
    const TsdfBlock* full = map.Find(block);
    if (!full) continue;
    for (int i = 0; i < kBlockVoxels; ++i) {
      const VoxelIndex in_block(i % kBlockSide, i / kBlockSide % kBlockSide, i / (kBlockSide * kBlockSide));
      const int at = TsdfBlock::IndexOf(in_block);
      if (!(full->weight[at] > 0)) continue;
      const bool occupied = full->distance_m[at] < grid.voxel_m() / 2;
      impl_->Set(grid, grid.BlockOrigin(block) + in_block, occupied ? Leaf::kOccupied : Leaf::kFree);
    }
  }
  impl_->Settle();
}

void OccupancyTree::Update(const PlanningMap& map) {
  const VoxelGrid& grid = map.grid();
  if (!impl_) impl_ = std::make_unique<Impl>(grid.voxel_m());
  impl_->version.resize(static_cast<std::size_t>(grid.num_blocks()), 0);
  impl_->leaf.resize(grid.num_voxels(), 0);
  for (int block = 0; block < grid.num_blocks(); ++block) {
    if (impl_->version[block] == map.block_version(block)) continue;
    impl_->version[block] = map.block_version(block);
    const VoxelIndex origin = grid.BlockOrigin(block);
    for (int i = 0; i < kBlockVoxels; ++i) {
      const VoxelIndex voxel =
          origin + VoxelIndex(i % kBlockSide, i / kBlockSide % kBlockSide, i / (kBlockSide * kBlockSide));
      const std::size_t linear = grid.Linear(voxel);
      if (map.state(linear) == VoxelState::kUnknown) continue;
      const Leaf leaf = map.distance_m(linear) < grid.voxel_m() / 2 ? Leaf::kOccupied : Leaf::kFree;
      if (impl_->leaf[linear] == static_cast<std::uint8_t>(leaf)) continue;
      impl_->leaf[linear] = static_cast<std::uint8_t>(leaf);
      impl_->Set(grid, voxel, leaf);
    }
  }
  impl_->Settle();
}

std::vector<std::uint8_t> OccupancyTree::Bytes() const {
  // OctoMap's own writeBinary says "done." on the terminal; its header is this one.
  const octomap::OcTree nothing(1.0);
  const octomap::OcTree& tree = impl_ ? impl_->tree : nothing;
  std::ostringstream stream;
  stream << "# Octomap OcTree binary file\n# (feel free to add / change comments, but leave the first line "
            "as it is!)\n#\nid "
         << tree.getTreeType() << "\nsize " << tree.size() << "\nres " << tree.getResolution() << "\ndata\n";
  if (tree.size() > 0) tree.writeBinaryData(stream);
  const std::string text = stream.str();
  return {text.begin(), text.end()};
}

void OccupancyTree::WriteBt(const std::string& path) const {
  const std::vector<std::uint8_t> bytes = Bytes();
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

OccupancyTree::Leaf OccupancyTree::At(const Eigen::Vector3d& p_W) const {
  const octomap::OcTreeNode* node = impl_ ? impl_->tree.search(p_W.x(), p_W.y(), p_W.z()) : nullptr;
  if (!node) return Leaf::kUnknown;
  return impl_->tree.isNodeOccupied(node) ? Leaf::kOccupied : Leaf::kFree;
}

}  // namespace citrine

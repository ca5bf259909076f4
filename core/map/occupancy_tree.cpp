#include "core/map/occupancy_tree.h"

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <octomap/OcTree.h>

#include "core/parallel_for.h"

namespace citrine {

namespace {

constexpr int kOctants = 8;

/// The leaves of one octant about the world's origin, where a tree of OctoMap's is divided first: under its
/// root hang the nodes that hang in this place in the tree of all.
class Octant {
 public:
  explicit Octant(double voxel_m) : tree_(voxel_m) {}

  void Set(const octomap::point3d& p_W, OccupancyTree::Leaf leaf) { changes_.emplace_back(p_W, leaf); }
  /// Sets the leaves in the tree and the nodes above them.
  void Settle() {
    if (changes_.empty()) return;
    const float occupied = tree_.getClampingThresMaxLog(), free = tree_.getClampingThresMinLog();
    for (const auto& [p_W, leaf] : changes_)
      tree_.setNodeValue(p_W, leaf == OccupancyTree::Leaf::kOccupied ? occupied : free, true);
    changes_.clear();
    tree_.updateInnerOccupancy();
    tree_.prune();
    std::ostringstream stream;
    tree_.writeBinaryData(stream);
    bytes_ = std::move(stream).str();
  }

  const octomap::OcTree& tree() const { return tree_; }
  /// In OctoMap's binary format, its header left out: which children the root has, then what hangs under it.
  const std::string& bytes() const { return bytes_; }

 private:
  octomap::OcTree tree_;
  std::vector<std::pair<octomap::point3d, OccupancyTree::Leaf>> changes_;  ///< not in the tree yet
  std::string bytes_;
};

int OctantOf(const octomap::point3d& p_W) {
  return (p_W.x() < 0 ? 0 : 1) + (p_W.y() < 0 ? 0 : 2) + (p_W.z() < 0 ? 0 : 4);
}

}  // namespace

struct OccupancyTree::Impl {
  explicit Impl(double voxel_m) : octants(kOctants, Octant(voxel_m)) {}
  /// Sets a leaf; the tree follows in Settle().
  void Set(const VoxelGrid& grid, const VoxelIndex& voxel, Leaf leaf_is);
  void Settle() {
    ParallelForEach(octants.size(), kOctants, [&](std::size_t i) { octants[i].Settle(); });
  }

  std::vector<Octant> octants;
  std::vector<std::uint32_t> version;  ///< of the blocks as last looked at
  std::vector<std::uint8_t> leaf;      ///< as in the tree: Leaf
};

OccupancyTree::OccupancyTree() = default;
OccupancyTree::~OccupancyTree() = default;

void OccupancyTree::Impl::Set(const VoxelGrid& grid, const VoxelIndex& voxel, Leaf leaf_is) {
  // A hair off the centre, so that rounding never puts two voxels into one leaf.
  const Eigen::Vector3f at_W =
      (grid.Centre(voxel) + Eigen::Vector3d::Constant(1e-4 * grid.voxel_m())).cast<float>();
  const octomap::point3d p_W(at_W.x(), at_W.y(), at_W.z());
  octants[static_cast<std::size_t>(OctantOf(p_W))].Set(p_W, leaf_is);
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
  std::string root(2, '\0'), under_root;
  std::size_t nodes = 0;
  for (int i = 0; impl_ && i < kOctants; ++i) {
    const Octant& octant = impl_->octants[static_cast<std::size_t>(i)];
    if (octant.bytes().empty()) continue;
    for (std::size_t k = 0; k < root.size(); ++k) root[k] = static_cast<char>(root[k] | octant.bytes()[k]);
    under_root.append(octant.bytes(), root.size());
    nodes += octant.tree().size() - 1;
  }
  // OctoMap's own writeBinary says "done." on the terminal; its header is this one.
  const octomap::OcTree like(impl_ ? impl_->octants[0].tree().getResolution() : 1.0);
  std::ostringstream stream;
  stream << "# Octomap OcTree binary file\n# (feel free to add / change comments, but leave the first line "
            "as it is!)\n#\nid "
         << like.getTreeType() << "\nsize " << (nodes > 0 ? nodes + 1 : 0) << "\nres " << like.getResolution()
         << "\ndata\n";
  if (nodes > 0) stream << root << under_root;
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
  if (!impl_) return Leaf::kUnknown;
  const octomap::point3d at_W(static_cast<float>(p_W.x()), static_cast<float>(p_W.y()),
                              static_cast<float>(p_W.z()));
  const octomap::OcTree& tree = impl_->octants[static_cast<std::size_t>(OctantOf(at_W))].tree();
  const octomap::OcTreeNode* node = tree.search(at_W);
  if (!node) return Leaf::kUnknown;
  return tree.isNodeOccupied(node) ? Leaf::kOccupied : Leaf::kFree;
}

}  // namespace citrine

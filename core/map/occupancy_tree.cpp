#include "core/map/occupancy_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace citrine {
namespace {

constexpr int kDepth = 16;                // of OctoMap's trees
constexpr int kKeyOfOrigin = 1 << 15;     // half of the keys lie below it
constexpr std::uint8_t kHasChildren = 3;  // beside the values of Leaf, as the binary stream writes them

int KeyOf(double coordinate_m, double per_m) {
  return static_cast<int>(std::floor(per_m * coordinate_m)) + kKeyOfOrigin;
}

}  // namespace

/// The nodes of the tree as arrays, one a level, over the keys that the grid has.
struct OccupancyTree::Impl {
  struct Level {
    Eigen::Vector3i first, size;  ///< keys, shifted
    std::vector<std::uint8_t> node;

    bool Has(const Eigen::Vector3i& key) const {
      return ((key - first).array() >= 0).all() && ((key - first).array() < size.array()).all();
    }
    std::size_t At(const Eigen::Vector3i& key) const {
      const Eigen::Vector3i k = key - first;
      return static_cast<std::size_t>(k.x()) +
             static_cast<std::size_t>(size.x()) * (k.y() + static_cast<std::size_t>(size.y()) * k.z());
    }
    std::uint8_t Get(const Eigen::Vector3i& key) const { return Has(key) ? node[At(key)] : 0; }
  };

  explicit Impl(const VoxelGrid& grid);
  Eigen::Vector3i KeyOfVoxel(const VoxelIndex& v) const {
    return {key[0][static_cast<std::size_t>(v.x())], key[1][static_cast<std::size_t>(v.y())],
            key[2][static_cast<std::size_t>(v.z())]};
  }
  bool Set(const VoxelIndex& voxel, Leaf leaf);
  void FollowBlock(const VoxelIndex& origin);
  std::uint8_t OfChildren(int level, const Eigen::Vector3i& at) const;
  void Write(int level, const Eigen::Vector3i& at, std::vector<std::uint8_t>& bytes,
             std::size_t& nodes) const;

  double voxel_m;
  std::array<std::vector<int>, 3> key;   ///< by axis and voxel
  std::array<Level, kDepth + 1> levels;  ///< from leaves to the root
  std::vector<std::uint32_t> version;    ///< of the blocks as last looked at
};

OccupancyTree::OccupancyTree() = default;
OccupancyTree::~OccupancyTree() = default;

OccupancyTree::Impl::Impl(const VoxelGrid& grid)
    : voxel_m(grid.voxel_m()), version(static_cast<std::size_t>(grid.num_blocks()), 0) {
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < grid.voxels()[axis]; ++i) {
      // A hair off the centre, so that rounding never puts two voxels into one leaf.
      const double hair_m = 1e-4 * voxel_m;
      const auto centre_m = static_cast<float>(grid.Centre(VoxelIndex::Constant(i))[axis] + hair_m);
      key[axis].push_back(KeyOf(centre_m, 1 / voxel_m));
    }
  // Voxels farther out than OctoMap's keys reach are not in the tree.
  const Eigen::Vector3i first = KeyOfVoxel(VoxelIndex::Zero()).cwiseMax(0);
  const Eigen::Vector3i last = KeyOfVoxel(grid.voxels() - VoxelIndex::Ones()).cwiseMin(2 * kKeyOfOrigin - 1);
  for (int level = 0; level <= kDepth; ++level) {
    Level& l = levels[static_cast<std::size_t>(level)];
    for (int axis = 0; axis < 3; ++axis) {
      l.first[axis] = first[axis] >> level;
      l.size[axis] = std::max(0, (last[axis] >> level) - l.first[axis] + 1);
    }
    l.node.assign(static_cast<std::size_t>(l.size.x()) * l.size.y() * l.size.z(), 0);
  }
}

/// @return whether it was another one
bool OccupancyTree::Impl::Set(const VoxelIndex& voxel, Leaf leaf) {
  const Eigen::Vector3i at = KeyOfVoxel(voxel);
  if (!levels[0].Has(at)) return false;
  std::uint8_t& node = levels[0].node[levels[0].At(at)];
  return std::exchange(node, static_cast<std::uint8_t>(leaf)) != static_cast<std::uint8_t>(leaf);
}

/// What a node is, by its children: eight leaves alike are one.
std::uint8_t OccupancyTree::Impl::OfChildren(int level, const Eigen::Vector3i& at) const {
  const Level& below = levels[static_cast<std::size_t>(level) - 1];
  const std::uint8_t first = below.Get(2 * at);
  if (first == kHasChildren) return kHasChildren;
  for (int child = 1; child < 8; ++child)
    if (below.Get(2 * at + Eigen::Vector3i(child & 1, child >> 1 & 1, child >> 2)) != first)
      return kHasChildren;
  return first;
}

/// Brings what lies over a block's leaves up to date.
void OccupancyTree::Impl::FollowBlock(const VoxelIndex& origin) {
  const Eigen::Vector3i low = KeyOfVoxel(origin);
  const Eigen::Vector3i high = KeyOfVoxel(origin + VoxelIndex::Constant(kBlockSide - 1));
  for (int level = 1; level <= kDepth; ++level) {
    Level& l = levels[static_cast<std::size_t>(level)];
    for (int z = low.z() >> level; z <= high.z() >> level; ++z)
      for (int y = low.y() >> level; y <= high.y() >> level; ++y)
        for (int x = low.x() >> level; x <= high.x() >> level; ++x)
          if (l.Has({x, y, z})) l.node[l.At({x, y, z})] = OfChildren(level, {x, y, z});
  }
}

/// A node with children: two bits for each of them, then those that have children themselves.
void OccupancyTree::Impl::Write(int level, const Eigen::Vector3i& at, std::vector<std::uint8_t>& bytes,
                                std::size_t& nodes) const {
  const Level& below = levels[static_cast<std::size_t>(level) - 1];
  std::array<std::uint8_t, 8> is;
  unsigned bits = 0;
  for (int child = 0; child < 8; ++child) {
    is[static_cast<std::size_t>(child)] =
        below.Get(2 * at + Eigen::Vector3i(child & 1, child >> 1 & 1, child >> 2));
    bits |= static_cast<unsigned>(is[static_cast<std::size_t>(child)]) << (2 * child);
    nodes += is[static_cast<std::size_t>(child)] != 0;
  }
  bytes.push_back(static_cast<std::uint8_t>(bits & 0xff));
  bytes.push_back(static_cast<std::uint8_t>(bits >> 8));
  for (int child = 0; child < 8; ++child)
    if (is[static_cast<std::size_t>(child)] == kHasChildren)
      Write(level - 1, 2 * at + Eigen::Vector3i(child & 1, child >> 1 & 1, child >> 2), bytes, nodes);
}

void OccupancyTree::Add(const TsdfMap& map) {
  const VoxelGrid& grid = map.grid();
  if (!impl_) impl_ = std::make_unique<Impl>(grid);
  for (int block = 0; block < grid.num_blocks(); ++block) {
    const TsdfBlock* full = map.Find(block);
    if (!full) continue;
    for (int i = 0; i < kBlockVoxels; ++i) {
      const VoxelIndex in_block(i % kBlockSide, i / kBlockSide % kBlockSide, i / (kBlockSide * kBlockSide));
      const int at = TsdfBlock::IndexOf(in_block);
      if (!(full->weight[at] > 0)) continue;
      const bool occupied = full->distance_m[at] < grid.voxel_m() / 2;
      impl_->Set(grid.BlockOrigin(block) + in_block, occupied ? Leaf::kOccupied : Leaf::kFree);
    }
    impl_->FollowBlock(grid.BlockOrigin(block));
  }
}

void OccupancyTree::Update(const PlanningMap& map) {
  const VoxelGrid& grid = map.grid();
  if (!impl_) impl_ = std::make_unique<Impl>(grid);
  for (int block = 0; block < grid.num_blocks(); ++block) {
    if (impl_->version[block] == map.block_version(block)) continue;
    impl_->version[block] = map.block_version(block);
    const VoxelIndex origin = grid.BlockOrigin(block);
    bool changed = false;
    for (int i = 0; i < kBlockVoxels; ++i) {
      const VoxelIndex voxel =
          origin + VoxelIndex(i % kBlockSide, i / kBlockSide % kBlockSide, i / (kBlockSide * kBlockSide));
      const std::size_t linear = grid.Linear(voxel);
      if (map.state(linear) == VoxelState::kUnknown) continue;
      changed |=
          impl_->Set(voxel, map.distance_m(linear) < grid.voxel_m() / 2 ? Leaf::kOccupied : Leaf::kFree);
    }
    if (changed) impl_->FollowBlock(origin);
  }
}

std::vector<std::uint8_t> OccupancyTree::Bytes() const {
  std::vector<std::uint8_t> data;
  std::size_t nodes = 0;
  if (impl_ && impl_->levels[kDepth].Get(Eigen::Vector3i::Zero()) == kHasChildren) {
    nodes = 1;
    impl_->Write(kDepth, Eigen::Vector3i::Zero(), data, nodes);
  }
  std::ostringstream header;
  header << "# Octomap OcTree binary file\n# (feel free to add / change comments, but leave the first line "
            "as it is!)\n#\nid OcTree\nsize "
         << nodes << "\nres " << (impl_ ? impl_->voxel_m : 1.0) << "\ndata\n";
  const std::string text = header.str();
  data.insert(data.begin(), text.begin(), text.end());
  return data;
}

void OccupancyTree::WriteBt(const std::string& path) const {
  const std::vector<std::uint8_t> bytes = Bytes();
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

OccupancyTree::Leaf OccupancyTree::At(const Eigen::Vector3d& p_W) const {
  if (!impl_) return Leaf::kUnknown;
  Eigen::Vector3i key;
  for (int axis = 0; axis < 3; ++axis) key[axis] = KeyOf(p_W[axis], 1 / impl_->voxel_m);
  return static_cast<Leaf>(impl_->levels[0].Get(key));
}

}  // namespace citrine

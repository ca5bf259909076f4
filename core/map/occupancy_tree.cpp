#include "core/map/occupancy_tree.h"

#include <bit>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace citrine {
namespace {

using Leaf = OccupancyTree::Leaf;
using ByteString = std::vector<std::uint8_t>;

// OctoMap's trees are 2^16 leaves wide, the world's origin in their middle; a cube is 2^3, as a block is.
constexpr int kRootLevel = 16, kCubeLevel = 3;
constexpr int kOrigin = 1 << (kRootLevel - 1);

constexpr unsigned kInner = 3;             // a node's two bits, unless they are Leaf's
constexpr unsigned kEachOfEight = 0x5555;  // the lower bits of eight children

Leaf ByDistance(double distance_m, double voxel_m) {
  return distance_m < voxel_m / 2 ? Leaf::kOccupied : Leaf::kFree;
}

/// The node so many levels above another.
VoxelIndex Above(int levels, const VoxelIndex& node) {
  return node.unaryExpr([levels](int place) { return place >> levels; });
}

/// Appends a node with what child(i) appends of its children, or nothing if they are leaves and alike.
/// @return the node's bits in its parent, as child(i) returns them
template <class Child>
unsigned AppendParent(ByteString& bytes, Child&& child) {
  const std::size_t at = bytes.size();
  bytes.resize(at + 2);
  unsigned children = 0;
  for (int i = 0; i < 8; ++i) children |= child(i) << 2 * i;
  const unsigned first = children % 4;
  if (first != kInner && children == first * kEachOfEight) {
    bytes.resize(at);
    return first;
  }
  bytes[at] = static_cast<std::uint8_t>(children);
  bytes[at + 1] = static_cast<std::uint8_t>(children >> 8);
  return kInner;
}

/// Appends the node above 8^level leaves, likewise.
unsigned AppendSubtree(int level, const Leaf* leaves, ByteString& bytes) {
  if (level == 0) return static_cast<unsigned>(*leaves);
  const int below = level - 1;
  return AppendParent(bytes, [&](int i) { return AppendSubtree(below, leaves + (i << 3 * below), bytes); });
}

/// The root and every child that is not unknown.
int CountNodes(const ByteString& data) {
  int nodes = data.empty() ? 0 : 1;
  for (const unsigned four : data) nodes += std::popcount((four | four >> 1) & kEachOfEight);
  return nodes;
}

}  // namespace

void OccupancyTree::Cover(const VoxelGrid& grid) {
  if (!cubes_.empty()) return;
  leaf_m_ = grid.voxel_m();
  // A hair off the centres, so that rounding never puts two voxels into one leaf.
  const auto key = [&](const VoxelIndex& voxel) {
    return KeyOf(grid.Centre(voxel) + Eigen::Vector3d::Constant(1e-4 * leaf_m_));
  };
  first_key_ = key(VoxelIndex::Zero());
  last_key_ = key(grid.voxels().array() - 1);
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < grid.voxels()[axis]; ++i) {
      VoxelIndex from_lowest = kBlockSide * Above(kCubeLevel, first_key_);
      from_lowest[axis] = key(VoxelIndex::Constant(i))[axis];
      along_[axis].push_back(LeafAt(from_lowest));
    }
  cubes_.resize(LeafAt(last_key_) / kBlockVoxels + 1);
  leaves_.resize(cubes_.size() * kBlockVoxels, Leaf::kUnknown);
}

VoxelIndex OccupancyTree::KeyOf(const Eigen::Vector3d& p_W) const {
  // Rounded to single precision and multiplied, as OctoMap does it.
  return (p_W.cast<float>().cast<double>() * (1 / leaf_m_)).array().floor().cast<int>() + kOrigin;
}

bool OccupancyTree::Covers(int level, const VoxelIndex& node) const {
  const VoxelIndex first = Above(level, first_key_), last = Above(level, last_key_);
  return (node.array() >= first.array()).all() && (node.array() <= last.array()).all();
}

std::size_t OccupancyTree::LeafAt(const VoxelIndex& key) const {
  const VoxelIndex first = Above(kCubeLevel, first_key_), last = Above(kCubeLevel, last_key_);
  const VoxelIndex cube = Above(kCubeLevel, key) - first, cubes = (last - first).array() + 1;
  const int at = cube.x() + cubes.x() * (cube.y() + cubes.y() * cube.z());
  return static_cast<std::size_t>(at) * kBlockVoxels + TsdfBlock::IndexOf(key);
}

void OccupancyTree::Set(const VoxelIndex& voxel, Leaf leaf) {
  const std::size_t at = along_[0][voxel.x()] + along_[1][voxel.y()] + along_[2][voxel.z()];
  if (leaf == Leaf::kUnknown || leaves_[at] == leaf) return;
  leaves_[at] = leaf;
  cubes_[at / kBlockVoxels].changed = true;
}

void OccupancyTree::WriteChangedCubes() {
  for (std::size_t i = 0; i < cubes_.size(); ++i) {
    Cube& cube = cubes_[i];
    if (!std::exchange(cube.changed, false)) continue;
    cube.bytes.clear();
    cube.bits = AppendSubtree(kCubeLevel, &leaves_[i * kBlockVoxels], cube.bytes);
  }
}

void OccupancyTree::Add(const TsdfMap& map) {
  const VoxelGrid& grid = map.grid();
  Cover(grid);
  for (int block = 0; block < grid.num_blocks(); ++block) {
    const TsdfBlock* full = map.Find(block);
    if (!full) continue;
    const VoxelIndex origin = grid.BlockOrigin(block);
    for (int i = 0; i < kBlockVoxels; ++i) {
      const VoxelIndex in_block(i % kBlockSide, i / kBlockSide % kBlockSide, i / (kBlockSide * kBlockSide));
      const int at = TsdfBlock::IndexOf(in_block);
      if (full->weight[at] > 0) Set(origin + in_block, ByDistance(full->distance_m[at], leaf_m_));
    }
  }
  WriteChangedCubes();
}

void OccupancyTree::Update(const PlanningMap& map) {
  const VoxelGrid& grid = map.grid();
  Cover(grid);
  version_.resize(static_cast<std::size_t>(grid.num_blocks()), 0);
  std::array<Leaf, 256> leaf_of{};  // by distance code
  for (int code = 1; code < 256; ++code)
    leaf_of[code] = ByDistance(map.quantisation().Distance(static_cast<std::uint8_t>(code)), leaf_m_);
  for (int block = 0; block < grid.num_blocks(); ++block) {
    const std::uint32_t version = map.block_version(block);
    if (std::exchange(version_[block], version) == version) continue;
    const VoxelIndex origin = grid.BlockOrigin(block);
    for (int row = 0; row < kBlockSide * kBlockSide; ++row) {
      const VoxelIndex first = origin + VoxelIndex(0, row % kBlockSide, row / kBlockSide);
      const std::uint8_t* codes = &map.distance_codes()[grid.Linear(first)];
      for (int x = 0; x < kBlockSide; ++x) Set(first + VoxelIndex(x, 0, 0), leaf_of[codes[x]]);
    }
  }
  WriteChangedCubes();
}

unsigned OccupancyTree::AppendNode(int level, const VoxelIndex& node, ByteString& bytes) const {
  if (!Covers(level, node)) return static_cast<unsigned>(Leaf::kUnknown);
  if (level > kCubeLevel)
    return AppendParent(bytes, [&](int i) {
      return AppendNode(level - 1, 2 * node + VoxelIndex(i & 1, i >> 1 & 1, i >> 2), bytes);
    });
  const Cube& cube = cubes_[LeafAt(node * kBlockSide) / kBlockVoxels];
  bytes.insert(bytes.end(), cube.bytes.begin(), cube.bytes.end());
  return cube.bits;
}

std::vector<std::uint8_t> OccupancyTree::Bytes() const {
  ByteString data;
  AppendNode(kRootLevel, VoxelIndex::Zero(), data);
  std::ostringstream header;
  header << "# Octomap OcTree binary file\n# (feel free to add / change comments, but leave the first line "
            "as it is!)\n#\nid OcTree\nsize "
         << CountNodes(data) << "\nres " << leaf_m_ << "\ndata\n";
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
  const VoxelIndex key = KeyOf(p_W);
  return Covers(0, key) ? leaves_[LeafAt(key)] : Leaf::kUnknown;
}

}  // namespace citrine

#include "planner/path/lattice_search.h"

#include <algorithm>
#include <limits>

namespace citrine::planner {

namespace {

constexpr std::uint32_t kGreed = 17;  ///< sixteenths: the heuristic is raised by 6 %

}  // namespace

LatticeSearch::LatticeSearch(const VoxelGrid& grid, int stride)
    : grid_(grid), stride_(stride), size_((grid.voxels().array() + stride - 1) / stride) {}

void LatticeSearch::Begin(const VoxelIndex& from) {
  if (nodes_.empty()) nodes_.resize(static_cast<std::size_t>(size_.x()) * size_.y() * size_.z());
  ++round_;
  offset_ = from.unaryExpr([this](int x) { return x % stride_; });
  open_.clear();
  const std::uint32_t node = NodeOf(from);
  nodes_[node] = {round_, 0, -1, false};
  nearest_ = node;
  nearest_estimate_ = std::numeric_limits<std::uint32_t>::max();
  Push({0, 0, node});
}

std::uint32_t LatticeSearch::NodeOf(const VoxelIndex& v) const {
  const VoxelIndex n = (v - offset_) / stride_;
  return static_cast<std::uint32_t>(n.x() + size_.x() * (n.y() + size_.y() * n.z()));
}

VoxelIndex LatticeSearch::VoxelOf(std::uint32_t node) const {
  const int n = static_cast<int>(node);
  return stride_ * VoxelIndex(n % size_.x(), n / size_.x() % size_.y(), n / (size_.x() * size_.y())) +
         offset_;
}

std::uint32_t LatticeSearch::Heuristic(const VoxelIndex& v, const VoxelIndex& to) const {
  Eigen::Vector3i d = (to - v).cwiseAbs() / stride_;
  std::sort(d.data(), d.data() + 3);
  const auto length = static_cast<std::uint32_t>(17 * d[0] + 14 * (d[1] - d[0]) + 10 * (d[2] - d[1]));
  return kUnitCost * length * kGreed / 16;
}

void LatticeSearch::Push(Open entry) {
  open_.push_back(entry);
  std::push_heap(open_.begin(), open_.end(), [](const Open& a, const Open& b) {
    if (a.estimate != b.estimate) return a.estimate > b.estimate;
    if (a.travelled != b.travelled) return a.travelled < b.travelled;
    return a.node > b.node;
  });
}

LatticeSearch::Open LatticeSearch::Pop() {
  std::pop_heap(open_.begin(), open_.end(), [](const Open& a, const Open& b) {
    if (a.estimate != b.estimate) return a.estimate > b.estimate;
    if (a.travelled != b.travelled) return a.travelled < b.travelled;
    return a.node > b.node;
  });
  const Open entry = open_.back();
  open_.pop_back();
  return entry;
}

std::vector<VoxelIndex> LatticeSearch::WayToNearest() const {
  return open_.empty() ? std::vector<VoxelIndex>{} : Trace(nearest_);
}

std::vector<VoxelIndex> LatticeSearch::Trace(std::uint32_t node) const {
  std::vector<VoxelIndex> way = {VoxelOf(node)};
  for (std::int8_t n = nodes_[node].from; n >= 0;) {
    way.push_back(way.back() - stride_ * VoxelIndex(kN26[n][0], kN26[n][1], kN26[n][2]));
    n = nodes_[NodeOf(way.back())].from;
  }
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace citrine::planner

#include "planner/path/topological_grid.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include "core/grid/neighbours.h"
#include "core/parallel_for.h"

namespace citrine::planner {

namespace {

constexpr int kCellVoxels = 4;
constexpr int kEmptyMin =
    48;  ///< of a cell's 64 voxels: a thin wall closes one of the two cells that it lies in
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

TopologicalGrid::TopologicalGrid(const PlanningMap& map)
    : map_(map),
      size_((map.grid().voxels().array() + kCellVoxels - 1) / kCellVoxels + 2),
      cell_m_(kCellVoxels * map.grid().voxel_m()) {
  for (std::size_t i = 0; i < neighbours_.size(); ++i) {
    const Eigen::Vector3i step(kN26[i][0], kN26[i][1], kN26[i][2]);
    neighbours_[i] = {step.x() + size_.x() * (step.y() + size_.y() * step.z()),
                      cell_m_ * step.cast<double>().norm()};
  }
}

void TopologicalGrid::ReadMap() {
  if (revision_ == map_.revision()) return;
  revision_ = map_.revision();
  std::vector<std::uint8_t> empty_voxels(static_cast<std::size_t>(size_.prod()), 0);
  const VoxelGrid& grid = map_.grid();
  const VoxelIndex lo = grid.inside_min(), hi = grid.inside_max();
  std::vector<std::uint8_t> empty(static_cast<std::size_t>(size_.x()) * kCellVoxels, 0);  // along a row
  for (int z = lo.z(); z < hi.z(); ++z)
    for (int y = lo.y(); y < hi.y(); ++y) {
      const std::uint8_t* row = &map_.states()[grid.Linear({0, y, z})];
      std::transform(row + lo.x(), row + hi.x(), empty.begin() + lo.x(), [](std::uint8_t state) {
        return static_cast<std::uint8_t>(state == static_cast<std::uint8_t>(VoxelState::kEmpty));
      });
      std::uint8_t* cells =
          &empty_voxels[1 + size_.x() * (1 + y / kCellVoxels + size_.y() * (1 + z / kCellVoxels))];
      for (int cell = 0; cell < size_.x() - 2; ++cell)
        for (int x = 0; x < kCellVoxels; ++x) cells[cell] += empty[cell * kCellVoxels + x];
    }
  free_.resize(empty_voxels.size());
  std::transform(empty_voxels.begin(), empty_voxels.end(), free_.begin(),
                 [](std::uint8_t count) { return count > kEmptyMin; });
}

int TopologicalGrid::CellOf(const Eigen::Vector3d& p_W) const {
  const VoxelIndex v = map_.grid().IndexOf(p_W);
  const Eigen::Vector3i c = (v.array().max(0) / kCellVoxels + 1).min(size_.array() - 2);
  return c.x() + size_.x() * (c.y() + size_.y() * c.z());
}

Eigen::Vector3d TopologicalGrid::Centre(int cell) const {
  const Eigen::Vector3i c(cell % size_.x(), cell / size_.x() % size_.y(), cell / (size_.x() * size_.y()));
  return map_.grid().origin_W() + (c.cast<double>().array() - 0.5).matrix() * cell_m_;
}

int TopologicalGrid::NearestFree(const Eigen::Vector3d& p_W) const {
  const int own = CellOf(p_W);
  if (free_[static_cast<std::size_t>(own)]) return own;
  int nearest = -1;
  double best = kInfinity;
  for (int row = 0; row < static_cast<int>(free_.size()); row += size_.x()) {
    if ((Centre(row) - p_W).tail<2>().squaredNorm() >= best) continue;
    for (int cell = row; cell < row + size_.x(); ++cell) {
      if (!free_[static_cast<std::size_t>(cell)]) continue;
      const double d2 = (Centre(cell) - p_W).squaredNorm();
      if (d2 < best) best = d2, nearest = cell;
    }
  }
  return nearest;
}

Eigen::MatrixXd TopologicalGrid::LengthsBetween(const std::vector<Eigen::Vector3d>& from_W,
                                                const std::vector<Eigen::Vector3d>& to_W) {
  ReadMap();
  std::vector<int> ends;
  for (const Eigen::Vector3d& p_W : to_W) ends.push_back(NearestFree(p_W));
  Eigen::MatrixXd lengths(from_W.size(), to_W.size());
  ParallelForEach(from_W.size(), static_cast<int>(from_W.size()), [&](std::size_t i) {
    lengths.row(static_cast<Eigen::Index>(i)) = LengthsFrom(from_W[i], to_W, ends);
  });
  return lengths;
}

Eigen::RowVectorXd TopologicalGrid::LengthsFrom(const Eigen::Vector3d& from_W,
                                                const std::vector<Eigen::Vector3d>& to_W,
                                                const std::vector<int>& ends) const {
  Eigen::RowVectorXd lengths =
      Eigen::RowVectorXd::Constant(static_cast<Eigen::Index>(to_W.size()), kInfinity);
  const int start = NearestFree(from_W);
  if (start < 0) return lengths;

  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<double> shortest_m(free_.size(), kInfinity);
  shortest_m[static_cast<std::size_t>(start)] = 0;
  open.push({0, start});
  std::vector<int> waited_for = ends;
  while (!open.empty() && !waited_for.empty()) {
    const auto [length, cell] = open.top();
    open.pop();
    if (length > shortest_m[static_cast<std::size_t>(cell)]) continue;
    std::erase(waited_for, cell);
    for (const Neighbour& neighbour : neighbours_) {
      const int next = cell + neighbour.cells;
      const auto i = static_cast<std::size_t>(next);
      const double there = length + neighbour.length_m;
      if (!free_[i] || there >= shortest_m[i]) continue;
      shortest_m[i] = there;
      open.push({there, next});
    }
  }
  for (std::size_t i = 0; i < to_W.size(); ++i) {
    double& length_m = lengths[static_cast<Eigen::Index>(i)];
    if (start == ends[i]) {
      length_m = (to_W[i] - from_W).norm();
      continue;
    }
    length_m = shortest_m[static_cast<std::size_t>(ends[i])] + (from_W - Centre(start)).norm() +
               (to_W[i] - Centre(ends[i])).norm();
  }
  return lengths;
}

}  // namespace citrine::planner

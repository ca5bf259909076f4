#include "planner/view/clear_cells.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace citrine::planner {

namespace {
constexpr int kSide = 4;  ///< [voxels]; a grid is made of blocks of 8, so cells fit
}  // namespace

ClearCells::ClearCells(const PlanningMap& map)
    : grid_(map.grid()), cells_(grid_.voxels() / kSide), clear_(static_cast<std::size_t>(cells_.prod()), 1) {
  constexpr std::uint32_t kFourEmpty = 0x01010101u * static_cast<std::uint32_t>(VoxelState::kEmpty);
  const int stride_y = cells_.x(), stride_z = cells_.x() * cells_.y();
  VoxelIndex v;
  for (v.z() = 0; v.z() < grid_.voxels().z(); ++v.z())
    for (v.y() = 0; v.y() < grid_.voxels().y(); ++v.y())
      for (v.x() = 0; v.x() < grid_.voxels().x(); v.x() += kSide) {
        std::uint32_t four;
        std::memcpy(&four, &map.states()[grid_.Linear(v)], sizeof four);
        four ^= kFourEmpty;
        if (four == 0) continue;
        // A voxel on the side of its cell spoils the neighbour too.
        const auto reach = [](int at) { return at % kSide == 0 ? -1 : (at % kSide == kSide - 1 ? 1 : 0); };
        const Eigen::Vector3i c = v / kSide;
        const int x_low = (four & 0xff) && c.x() > 0 ? -1 : 0;
        const int x_high = (four >> 24) && c.x() + 1 < cells_.x() ? 1 : 0;
        const int ry = reach(v.y()), rz = reach(v.z());
        for (int k = 0; k < 4; ++k) {
          const int dy = k & 1 ? ry : 0, dz = k & 2 ? rz : 0;
          if (((k & 1) && ry == 0) || ((k & 2) && rz == 0)) continue;
          const int y = c.y() + dy, z = c.z() + dz;
          if (y < 0 || y >= cells_.y() || z < 0 || z >= cells_.z()) continue;
          std::uint8_t* const cell = &clear_[c.x() + stride_y * y + static_cast<std::size_t>(stride_z) * z];
          for (int dx = x_low; dx <= x_high; ++dx) cell[dx] = 0;
        }
      }
}

double ClearCells::ClearFrom(const Eigen::Vector3d& element_W, const Eigen::Vector3d& view_W) const {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const double inv_cell = 1 / (kSide * grid_.voxel_m());
  const int strides[3] = {1, cells_.x(), cells_.x() * cells_.y()};
  double next[3], stride[3];
  int left[3], step[3];
  std::ptrdiff_t at = 0;
  int steps = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (view_W[axis] - grid_.origin_W()[axis]) * inv_cell;
    const double b = (element_W[axis] - grid_.origin_W()[axis]) * inv_cell;
    const int from = static_cast<int>(a), to = static_cast<int>(b);
    at += static_cast<std::ptrdiff_t>(from) * strides[axis];
    left[axis] = std::abs(to - from);
    steps += left[axis];
    step[axis] = to > from ? strides[axis] : -strides[axis];
    stride[axis] = left[axis] > 0 ? 1 / std::abs(b - a) : kNever;
    next[axis] = left[axis] > 0 ? ((to > from ? from + 1 : from) - a) / (b - a) : kNever;
  }
  if (!clear_[at]) return 1;
  for (int i = 0; i < steps; ++i) {
    const int axis = next[0] <= next[1] ? (next[0] <= next[2] ? 0 : 2) : (next[1] <= next[2] ? 1 : 2);
    const double here = next[axis];
    at += step[axis];
    next[axis] = --left[axis] == 0 ? kNever : next[axis] + stride[axis];
    if (!clear_[at]) return 1 - here;
  }
  return 0;
}

}  // namespace citrine::planner

#include "planner/view/visibility.h"

#include <array>
#include <cmath>
#include <limits>

namespace citrine::planner {

Sight LookAt(const PlanningMap& map, const Element& element, const Eigen::Vector3d& view_W, int unknown_max) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const VoxelGrid& grid = map.grid();
  const VoxelIndex end = grid.IndexOf(view_W);
  const Eigen::Vector3d along = view_W - element.p_W;
  if (!grid.Contains(end)) return {};

  // From the element outwards: what hides it is most often near it.
  double next[3], stride[3];
  int left[3];
  std::ptrdiff_t step[3];
  const std::ptrdiff_t strides[3] = {1, static_cast<std::ptrdiff_t>(grid.stride_y()),
                                     static_cast<std::ptrdiff_t>(grid.stride_z())};
  int steps = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int voxels = end[axis] - element.voxel[axis];
    left[axis] = std::abs(voxels);
    steps += left[axis];
    step[axis] = voxels > 0 ? strides[axis] : -strides[axis];
    stride[axis] = left[axis] > 0 ? grid.voxel_m() / std::abs(along[axis]) : kNever;
    next[axis] = left[axis] > 0 ? 0.5 * stride[axis] : kNever;
  }
  const bool in_front = element.normal_W.dot(along) > 0;
  const int full[3] = {left[0], left[1], left[2]};
  const std::uint8_t* const states = map.states().data();
  auto at = static_cast<std::ptrdiff_t>(element.linear);
  bool touching = true;
  Sight sight;
  for (int i = 1; i < steps; ++i) {
    const int axis = next[0] <= next[1] ? (next[0] <= next[2] ? 0 : 2) : (next[1] <= next[2] ? 1 : 2);
    at += step[axis];
    next[axis] = --left[axis] == 0 ? kNever : next[axis] + stride[axis];
    const std::uint8_t state = states[at];
    if (touching) touching = full[axis] - left[axis] <= 1;
    if (state == static_cast<std::uint8_t>(VoxelState::kOccupied)) {
      if (!touching || !in_front) return sight;
    } else if (state == static_cast<std::uint8_t>(VoxelState::kUnknown)) {
      if (++sight.unknown > unknown_max) return sight;
    }
  }
  sight.clear = true;
  return sight;
}

double ClearProbability(int unknown) {
  static const std::array<double, 64> table = [] {
    std::array<double, 64> t{};
    for (int u = 0; u < 64; ++u) t[u] = std::exp(-u);
    return t;
  }();
  return unknown < 64 ? table[unknown] : std::exp(-unknown);
}

}  // namespace citrine::planner

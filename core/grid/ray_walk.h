#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "core/grid/voxel_grid.h"

namespace citrine {

/// Visits the voxels that the segment from a to b passes, in order, both ends included (Amanatides & Woo
/// 1987).
///
/// Voxels outside the grid are passed over in silence.
/// @param visit  bool(const VoxelIndex&): whether to go on
/// @return false if the walk was stopped by `visit`
template <class Visit>
bool WalkRay(const VoxelGrid& grid, const Eigen::Vector3d& a_W, const Eigen::Vector3d& b_W, Visit&& visit) {
  VoxelIndex voxel = grid.IndexOf(a_W);
  const VoxelIndex end = grid.IndexOf(b_W);
  const Eigen::Vector3d along = b_W - a_W;
  std::array<double, 3> next, stride;  // share of the segment at the next face, and from face to face
  std::array<int, 3> step, left;
  for (int axis = 0; axis < 3; ++axis) {
    step[axis] = end[axis] > voxel[axis] ? 1 : -1;
    left[axis] = std::abs(end[axis] - voxel[axis]);
    next[axis] = stride[axis] = std::numeric_limits<double>::infinity();
    if (left[axis] == 0) continue;
    const double face = grid.origin_W()[axis] + (voxel[axis] + (step[axis] > 0 ? 1 : 0)) * grid.voxel_m();
    next[axis] = (face - a_W[axis]) / along[axis];
    stride[axis] = grid.voxel_m() / std::abs(along[axis]);
  }
  for (;;) {
    if (grid.Contains(voxel) && !visit(static_cast<const VoxelIndex&>(voxel))) return false;
    const int axis = next[0] <= next[1] ? (next[0] <= next[2] ? 0 : 2) : (next[1] <= next[2] ? 1 : 2);
    if (left[axis] == 0) return true;  // every axis has arrived: its next face is infinitely far
    voxel[axis] += step[axis];
    next[axis] = --left[axis] == 0 ? std::numeric_limits<double>::infinity() : next[axis] + stride[axis];
  }
}

}  // namespace citrine

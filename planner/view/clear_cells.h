#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/map/planning_map.h"

namespace citrine::planner {

/// Cells of 4x4x4 voxels in which, and within one voxel of which, all is known to be empty: there a line of
/// sight need not be walked voxel by voxel.
class ClearCells {
 public:
  explicit ClearCells(const PlanningMap& map);

  /// The share of the segment from a view to an element, seen from the element, from which on only clear
  /// cells are passed: 0 if all are, 1 (or more) if the view's own cell is not.
  double ClearFrom(const Eigen::Vector3d& element_W, const Eigen::Vector3d& view_W) const;

 private:
  VoxelGrid grid_;
  Eigen::Vector3i cells_;
  std::vector<std::uint8_t> clear_;
};

}  // namespace citrine::planner

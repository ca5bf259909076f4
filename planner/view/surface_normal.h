#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

#include "core/map/planning_map.h"

namespace citrine::planner {

/// Normals of surface elements after Hardouin et al. (IROS 2020), with confidence (paper, IV-A): the sum of
/// the unit vectors to the 26 neighbours, each times its weight, positive where empty and negative where
/// occupied.
///
/// Weights are clipped to w*. Where the quantised map carries none (outside the surface band) a known voxel
/// counts with w*; an unknown one, or one outside the volume, with nothing.
class SurfaceNormal {
 public:
  SurfaceNormal(const PlanningMap& map, double w_star);

  /// Unit normal at a voxel, pointing into the empty space; zero where the neighbours cancel out.
  Eigen::Vector3d At(const VoxelIndex& v) const;

 private:
  const PlanningMap& map_;
  std::array<double, 256> weight_;  ///< by weight code
  std::array<Eigen::Vector3d, 26> direction_;
  std::array<std::ptrdiff_t, 26> step_;
};

}  // namespace citrine::planner

#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "core/quality/active_surface.h"

namespace citrine::planner {

/// One active surface element as views see it.
struct Element {
  std::uint32_t linear = 0;  ///< voxel
  SurfaceClass kind = SurfaceClass::kIse;
  VoxelIndex voxel = VoxelIndex::Zero();
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();       ///< [m] voxel centre
  Eigen::Vector3d normal_W = Eigen::Vector3d::Zero();  ///< unit, into the empty space; zero if unclear
  double d_star_m = 0;                                 ///< of its region
  double weight = 0;                                   ///< as the quantised map carries it
  int attempts = 0;                                    ///< views reached that should have settled it
};

/// The elements of an active surface, ascending by voxel, but those that `skip` names; with their normals.
std::vector<Element> ListElements(const PlanningMap& map, const ActiveSurface& surface,
                                  const std::function<bool(std::uint32_t linear)>& skip);

}  // namespace citrine::planner

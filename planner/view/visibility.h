#pragma once

#include <array>
#include <limits>

#include <Eigen/Core>

#include "core/map/planning_map.h"
#include "planner/view/elements.h"

namespace citrine::planner {

/// What lies between a view and an element.
struct Sight {
  bool clear = false;  ///< delta of eq. (7): no occupied voxel in between
  int unknown = 0;     ///< u of eq. (7): unknown voxels in between; counted up to the first occupied one
};

/// Walks the voxels strictly between an element and a view, exactly (the segment from the element's centre to
/// the view).
///
/// The element's own voxel and the view's occlude nothing. Voxels that touch the element (the 26 around it)
/// belong to the same surface: occupied ones do not occlude it from a view in front of it, that is where
/// normal . (view - element) > 0. A view outside the grid sees nothing.
/// @param unknown_max  if there are more unknown voxels the walk ends, and the sight is not clear
Sight LookAt(const PlanningMap& map, const Element& element, const Eigen::Vector3d& view_W,
             int unknown_max = std::numeric_limits<int>::max());

/// The same for eight pairs of an element and a view at once, which is faster.
std::array<Sight, 8> LookAtEight(const PlanningMap& map, const std::array<const Element*, 8>& elements,
                                 const std::array<const Eigen::Vector3d*, 8>& views_W);
inline std::array<Sight, 8> LookAtEight(const PlanningMap& map, const std::array<const Element*, 8>& elements,
                                        const Eigen::Vector3d& view_W) {
  std::array<const Eigen::Vector3d*, 8> views_W;
  views_W.fill(&view_W);
  return LookAtEight(map, elements, views_W);
}

/// exp(-u): the probability that nothing unknown hides the element (eq. 7).
double ClearProbability(int unknown);

/// vis(v, e) of eq. (7).
inline double Visibility(const Sight& sight) { return sight.clear ? ClearProbability(sight.unknown) : 0.0; }

}  // namespace citrine::planner

#pragma once

#include <vector>

#include "planner/view/elements.h"
#include "planner/view/view.h"

namespace citrine::planner {

/// Which candidates are left out of V_r before the paper's score decides (a choice of this project).
struct ShortlistRules {
  double tidy_m = 0;          ///< small groups within it come first; 0: the paper's letter
  int leftover_elements = 0;  ///< that a small group has at most
  double hop_min_m = 0;       ///< nearer views are left out where the surface goes on; 0: the paper's letter
};

/// Takes views out that lead to back-and-forth.
///
/// Where small groups of elements are near, or nothing else is left, the views of the nearest alone stay:
/// whoever leaves them behind has to come back for them, and J_I, normalised to the few that are left, would
/// send the UAV across the map for one element more. Elsewhere views nearer than a hop are left out if there
/// are others within two hops: J_N would have the UAV nibble at the edge of what it sees.
/// @param elements ascending by voxel, those of the views among them  @param p_W where the UAV is [m]
void Shorten(std::vector<View>& views, const std::vector<Element>& elements, const Eigen::Vector3d& p_W,
             const ShortlistRules& rules);

}  // namespace citrine::planner

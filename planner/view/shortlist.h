#pragma once

#include <vector>

#include "planner/view/view.h"

namespace citrine::planner {

/// Takes views nearer than a hop out if there are others within two hops: the surface goes on, and J_N would
/// have the UAV nibble at the edge of what it sees (a choice of this project).
/// @param p_W where the UAV is [m]  @param hop_m 0: the paper's letter
void LeaveNearOnes(std::vector<View>& views, const Eigen::Vector3d& p_W, double hop_m);

}  // namespace citrine::planner

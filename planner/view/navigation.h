#pragma once

#include <vector>

#include <Eigen/Core>

#include "planner/view/view.h"

namespace citrine::planner {

/// psi of eq. (11): 1 straight ahead, 0 straight back; 1 below 0.1 m/s, where a velocity has no direction.
double Alignment(const Eigen::Vector3d& velocity_W, const Eigen::Vector3d& to_view_W);

/// J_N of eq. (10) for every view. Distances count as at least a voxel, in both places.
/// @param p_W, velocity_W the UAV's [m], [m/s]
std::vector<double> NavigationScores(const std::vector<View>& views, const Eigen::Vector3d& p_W,
                                     const Eigen::Vector3d& velocity_W, double voxel_m);

}  // namespace citrine::planner

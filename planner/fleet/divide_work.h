#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "planner/fleet/balanced_kmeans.h"

namespace citrine::planner {

/// [m] from each of several points (a row) to each of others (a column) through known free space; infinity
/// where there is no way.
using LengthsBetween = std::function<Eigen::MatrixXd(const std::vector<Eigen::Vector3d>& from_W,
                                                     const std::vector<Eigen::Vector3d>& to_W)>;

/// Balanced clustering and its assignment (paper, IV-C): the centroid of each UAV's share of the elements.
/// @param uavs_W where each goes, and the one that divides is  @param elements_W at least as many 1 m cells
/// as UAVs
/// @return one a UAV; empty where the elements fill fewer cells than there are UAVs
std::vector<Eigen::Vector3d> DivideWork(const std::vector<Eigen::Vector3d>& elements_W,
                                        const std::vector<Eigen::Vector3d>& uavs_W,
                                        const LengthsBetween& lengths_between, const SizeRule& rule,
                                        std::uint64_t seed);

}  // namespace citrine::planner

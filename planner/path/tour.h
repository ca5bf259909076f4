#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace citrine::planner {

/// A short way from a start through every place, without coming back: their indices in order.
///
/// Nearest neighbour, then 2-opt and Or-opt moves until none shortens it (Croes 1958; Or 1976).
std::vector<std::size_t> ShortTour(const Eigen::Vector3d& start_W,
                                   const std::vector<Eigen::Vector3d>& places_W);

}  // namespace citrine::planner

#pragma once

#include <vector>

#include <Eigen/Core>

namespace citrine::planner {

/// The cheapest one-to-one assignment of rows to columns of a square cost matrix (Kuhn 1955, Munkres 1957).
/// @param cost finite entries  @return the column of each row
std::vector<int> Assign(const Eigen::MatrixXd& cost);

}  // namespace citrine::planner

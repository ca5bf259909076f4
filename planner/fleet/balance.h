#pragma once

#include <vector>

#include <Eigen/Core>

namespace citrine::planner {

/// Index of the generator nearest to a point: whose Voronoi cell it lies in (eq. 14). Ties: the lowest.
int VoronoiCell(const Eigen::Vector3d& p_W, const std::vector<Eigen::Vector3d>& generators_W);

/// |Vor(x_i)| of every generator.
std::vector<int> VoronoiShares(const std::vector<Eigen::Vector3d>& points_W,
                               const std::vector<Eigen::Vector3d>& generators_W);

/// f_r of eq. (13): half the sum of squared deviations from equal shares.
double Imbalance(const std::vector<int>& shares);

/// f_min of eq. (15) with Delta = |ASE| / (N (N + 1)): what one UAV with a share of |ASE| / (N + 1) amounts
/// to at least.
double ImbalanceThreshold(int elements, int uavs);

/// Whether the fleet is to be balanced: f_r > f_min; never for one UAV or fewer than 4 elements a UAV
/// (design, section 6).
/// @param starved if not 0, only where besides some UAV's share is below this part of |ASE| / (N + 1): shares
/// of 25, 35 and 40 % are beyond f_min already (a choice of this project)
bool Unbalanced(const std::vector<Eigen::Vector3d>& elements_W, const std::vector<Eigen::Vector3d>& uavs_W,
                double starved = 0);

}  // namespace citrine::planner

#include "planner/fleet/balance.h"

#include <algorithm>

namespace citrine::planner {

int VoronoiCell(const Eigen::Vector3d& p_W, const std::vector<Eigen::Vector3d>& generators_W) {
  int nearest = 0;
  for (std::size_t i = 1; i < generators_W.size(); ++i)
    if ((p_W - generators_W[i]).squaredNorm() < (p_W - generators_W[nearest]).squaredNorm())
      nearest = static_cast<int>(i);
  return nearest;
}

std::vector<int> VoronoiShares(const std::vector<Eigen::Vector3d>& points_W,
                               const std::vector<Eigen::Vector3d>& generators_W) {
  std::vector<int> shares(generators_W.size());
  for (const Eigen::Vector3d& p_W : points_W) ++shares[VoronoiCell(p_W, generators_W)];
  return shares;
}

double Imbalance(const std::vector<int>& shares) {
  double total = 0;
  for (const int share : shares) total += share;
  const double equal = total / static_cast<double>(shares.size());
  double sum = 0;
  for (const int share : shares) sum += (equal - share) * (equal - share);
  return 0.5 * sum;
}

double ImbalanceThreshold(int elements, int uavs) {
  const double n = uavs;
  const double delta = elements / (n * (n + 1));
  return delta * delta * n / (2 * (n - 1));
}

bool Unbalanced(const std::vector<Eigen::Vector3d>& elements_W, const std::vector<Eigen::Vector3d>& uavs_W,
                double starved) {
  const int elements = static_cast<int>(elements_W.size()), uavs = static_cast<int>(uavs_W.size());
  if (uavs < 2 || elements < 4 * uavs) return false;
  const std::vector<int> shares = VoronoiShares(elements_W, uavs_W);
  if (starved > 0 && *std::min_element(shares.begin(), shares.end()) >= starved * elements / (uavs + 1.0))
    return false;
  return Imbalance(shares) > ImbalanceThreshold(elements, uavs);
}

}  // namespace citrine::planner

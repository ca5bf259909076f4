#include "planner/fleet/divide_work.h"

#include <cmath>

#include "planner/fleet/assignment.h"
#include "planner/fleet/balanced_kmeans.h"

namespace citrine::planner {

namespace {
constexpr double kNoWay_m = 1e5;  ///< on top of the straight line, where no way is known
}  // namespace

std::vector<Eigen::Vector3d> DivideWork(const std::vector<Eigen::Vector3d>& elements_W,
                                        const std::vector<Eigen::Vector3d>& uavs_W,
                                        const LengthsBetween& lengths_between, const SizeRule& rule,
                                        std::uint64_t seed) {
  const std::vector<WeightedPoint> cells = GatherCells(elements_W);
  const int n = static_cast<int>(uavs_W.size());
  if (static_cast<int>(cells.size()) < n) return {};
  const Clusters clusters = BalancedKmeans(cells, n, rule, seed);
  Eigen::MatrixXd length_m = lengths_between(uavs_W, clusters.centroid_W);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      if (!std::isfinite(length_m(i, j)))
        length_m(i, j) = kNoWay_m + (uavs_W[i] - clusters.centroid_W[j]).norm();
  const std::vector<int> cluster_of = Assign(length_m);
  std::vector<Eigen::Vector3d> centroids(n);
  for (int i = 0; i < n; ++i) centroids[i] = clusters.centroid_W[cluster_of[i]];
  return centroids;
}

}  // namespace citrine::planner

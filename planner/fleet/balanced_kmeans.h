#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace citrine::planner {

/// A point that stands for several elements.
struct WeightedPoint {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
  int weight = 1;
};

/// How regularised k-means (paper, IV-C, after Lin et al. 2019) holds the sizes n_j of clusters together.
struct SizeRule {
  /// nullopt: the hard form, sizes differ by at most one element. Else the soft form: a division costs
  /// lambda k / n sum n_j^2 [m^2] on top of its squared distances, n elements in k clusters; 0 is plain
  /// k-means.
  std::optional<double> lambda_m2;
};

/// The clusters of a balanced k-means; a point's elements may be shared between clusters.
struct Clusters {
  std::vector<Eigen::Vector3d> centroid_W;
  std::vector<std::vector<int>> share;  ///< share[point][cluster]: elements
  std::vector<int> size;                ///< elements of each cluster
  double cost_m2 = 0;  ///< squared distances of elements to their centroid, and what sizes cost
  int iterations = 0;
};

/// The cheapest division of elements among centroids under a rule of sizes: an exact minimum cost flow.
Clusters Divide(const std::vector<WeightedPoint>& points, const std::vector<Eigen::Vector3d>& centroids_W,
                const SizeRule& rule);

/// Regularised k-means. Begins at k distinct points drawn by `seed`; ends when no division changes, at the
/// latest after 50 rounds.
/// @param points at least k
Clusters BalancedKmeans(const std::vector<WeightedPoint>& points, int k, const SizeRule& rule,
                        std::uint64_t seed);

/// Elements as 1 m cells: the centre of gravity of each cell's elements and their number, in order of cell.
std::vector<WeightedPoint> GatherCells(const std::vector<Eigen::Vector3d>& elements_W, double cell_m = 1.0);

}  // namespace citrine::planner

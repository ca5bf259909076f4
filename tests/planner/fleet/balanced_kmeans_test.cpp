#include "planner/fleet/balanced_kmeans.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "core/random.h"

namespace citrine::planner {
namespace {

std::vector<WeightedPoint> Points(Random& random, int n, int weight_max) {
  std::vector<WeightedPoint> points;
  for (int i = 0; i < n; ++i) {
    const double x = random.Uniform(0, 20), y = random.Uniform(0, 20);
    points.push_back({{x, y, random.Uniform(0, 5)}, 1 + static_cast<int>(random.Below(weight_max))});
  }
  return points;
}

TEST(BalancedKmeans, MakesClustersWhoseSizesDifferByAtMostOneElement) {
  Random random(4);
  for (int trial = 0; trial < 30; ++trial) {
    const int k = 2 + static_cast<int>(random.Below(5));
    const std::vector<WeightedPoint> points =
        Points(random, k + static_cast<int>(random.Below(80)), trial % 2 ? 1 : 9);
    const Clusters clusters = BalancedKmeans(points, k, {}, trial);
    const auto [least, most] = std::minmax_element(clusters.size.begin(), clusters.size.end());
    ASSERT_LE(*most - *least, 1);
    for (std::size_t i = 0; i < points.size(); ++i)
      ASSERT_EQ(std::accumulate(clusters.share[i].begin(), clusters.share[i].end(), 0), points[i].weight);
  }
}

/// The cheapest of all divisions of points of weight 1, by trying them all.
double CheapestOfAll(const std::vector<WeightedPoint>& points, const std::vector<Eigen::Vector3d>& centroids,
                     const SizeRule& rule) {
  const int n = static_cast<int>(points.size()), k = static_cast<int>(centroids.size());
  double best = 1e18;
  const int codes = static_cast<int>(std::lround(std::pow(k, n)));
  for (int code = 0; code < codes; ++code) {
    std::vector<int> size(k);
    double cost = 0;
    for (int i = 0, rest = code; i < n; ++i, rest /= k) {
      ++size[rest % k];
      cost += (points[i].p_W - centroids[rest % k]).squaredNorm();
    }
    const auto [least, most] = std::minmax_element(size.begin(), size.end());
    if (!rule.lambda_m2 && *most - *least > 1) continue;
    for (const int m : size) cost += rule.lambda_m2.value_or(0) * k / n * m * m;
    best = std::min(best, cost);
  }
  return best;
}

TEST(Divide, IsAsCheapAsTheBestOfAllDivisions) {
  Random random(8);
  for (int trial = 0; trial < 40; ++trial) {
    const int n = 5 + static_cast<int>(random.Below(4)), k = 2 + trial % 2;
    const std::vector<WeightedPoint> points = Points(random, n, 1);
    std::vector<Eigen::Vector3d> centroids;
    for (const WeightedPoint& p : Points(random, k, 1)) centroids.push_back(p.p_W);
    for (const SizeRule& rule : {SizeRule{}, SizeRule{0.0}, SizeRule{5.0}, SizeRule{80.0}}) {
      const double best = CheapestOfAll(points, centroids, rule);
      ASSERT_NEAR(Divide(points, centroids, rule).cost_m2, best, 1e-9 * best);
    }
  }
}

TEST(Divide, MakesSizesMoreAlikeTheMoreTheyCost) {
  Random random(5);
  std::vector<WeightedPoint> points = Points(random, 120, 9);
  const std::vector<Eigen::Vector3d> centroids{{2, 2, 2}, {4, 4, 2}, {18, 18, 2}};
  int last = std::numeric_limits<int>::max();
  for (const double lambda_m2 : {0.0, 10.0, 100.0, 1e6}) {
    const std::vector<int> size = Divide(points, centroids, {lambda_m2}).size;
    const auto [least, most] = std::minmax_element(size.begin(), size.end());
    EXPECT_LT(*most - *least, last);
    last = *most - *least;
  }
  EXPECT_LE(last, 1);
}

TEST(Divide, IsPlainKmeansWhereSizesCostNothing) {
  Random random(6);
  const std::vector<WeightedPoint> points = Points(random, 120, 9);
  const std::vector<Eigen::Vector3d> centroids{{2, 2, 2}, {4, 4, 2}, {18, 18, 2}};
  const Clusters plain = Divide(points, centroids, {0.0});
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < centroids.size(); ++j) {
      if (plain.share[i][j] == 0) continue;
      for (const Eigen::Vector3d& other : centroids)
        ASSERT_LE((points[i].p_W - centroids[j]).norm(), (points[i].p_W - other).norm());
    }
}

TEST(BalancedKmeans, IsTheSameForTheSameSeed) {
  Random random(2);
  const std::vector<WeightedPoint> points = Points(random, 60, 5);
  EXPECT_EQ(BalancedKmeans(points, 3, {}, 5).share, BalancedKmeans(points, 3, {}, 5).share);
}

}  // namespace
}  // namespace citrine::planner

#include "planner/fleet/balanced_kmeans.h"

#include <algorithm>
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
    const Clusters clusters = BalancedKmeans(points, k, trial);
    const auto [least, most] = std::minmax_element(clusters.size.begin(), clusters.size.end());
    ASSERT_LE(*most - *least, 1);
    for (std::size_t i = 0; i < points.size(); ++i)
      ASSERT_EQ(std::accumulate(clusters.share[i].begin(), clusters.share[i].end(), 0), points[i].weight);
  }
}

TEST(DivideEqually, IsAsCheapAsTheBestOfAllEqualDivisions) {
  Random random(8);
  for (int trial = 0; trial < 40; ++trial) {
    const int n = 5 + static_cast<int>(random.Below(4)), k = 2 + trial % 2;
    const std::vector<WeightedPoint> points = Points(random, n, 1);
    std::vector<Eigen::Vector3d> centroids;
    for (const WeightedPoint& p : Points(random, k, 1)) centroids.push_back(p.p_W);
    double best = 1e18;
    int codes = 1;
    for (int i = 0; i < n; ++i) codes *= k;
    for (int code = 0; code < codes; ++code) {
      std::vector<int> size(k);
      double cost = 0;
      for (int i = 0, rest = code; i < n; ++i, rest /= k) {
        ++size[rest % k];
        cost += (points[i].p_W - centroids[rest % k]).squaredNorm();
      }
      if (*std::max_element(size.begin(), size.end()) - *std::min_element(size.begin(), size.end()) <= 1)
        best = std::min(best, cost);
    }
    ASSERT_NEAR(DivideEqually(points, centroids).cost_m2, best, 1e-9 * best);
  }
}

TEST(BalancedKmeans, IsTheSameForTheSameSeed) {
  Random random(2);
  const std::vector<WeightedPoint> points = Points(random, 60, 5);
  EXPECT_EQ(BalancedKmeans(points, 3, 5).share, BalancedKmeans(points, 3, 5).share);
}

}  // namespace
}  // namespace citrine::planner

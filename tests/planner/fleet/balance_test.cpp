#include "planner/fleet/balance.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace citrine::planner {
namespace {

TEST(Balance, ThresholdForThreeUavsIsTheSquareOfTheElementsOver192) {
  EXPECT_NEAR(ImbalanceThreshold(960, 3), 960.0 * 960.0 / 192, 1e-9);  // paper, IV-C
}

TEST(Balance, ThresholdIsTheLeastImbalanceWithOneUavAtItsShareOverNPlusOne) {
  // One UAV has |ASE| / (N + 1), the others share the rest alike: that is where eq. (15) is tight.
  for (int n = 2; n <= 6; ++n) {
    const int elements = n * (n + 1) * (n - 1) * 10;
    std::vector<int> shares(n, (elements - elements / (n + 1)) / (n - 1));
    shares[0] = elements / (n + 1);
    EXPECT_NEAR(Imbalance(shares), ImbalanceThreshold(elements, n), 1e-6 * elements) << n;
    --shares[0];
    ++shares[1];
    EXPECT_GT(Imbalance(shares), ImbalanceThreshold(elements, n)) << n;
  }
}

TEST(Balance, SharesAreThoseOfTheVoronoiCells) {
  Random random(1);
  const auto point = [&] {
    return Eigen::Vector3d(random.Uniform(0, 9), random.Uniform(0, 9), random.Uniform(0, 9));
  };
  std::vector<Eigen::Vector3d> points, generators;
  for (int i = 0; i < 200; ++i) points.push_back(point());
  for (int i = 0; i < 4; ++i) generators.push_back(point());
  std::vector<int> expected(4);
  for (const auto& p : points)
    for (int i = 0; i < 4; ++i) {
      bool mine = true;
      for (int j = 0; j < 4; ++j) mine &= (p - generators[i]).norm() <= (p - generators[j]).norm();
      expected[i] += mine;
    }
  EXPECT_EQ(VoronoiShares(points, generators), expected);
}

TEST(Balance, IsCorrectedForSharesOf25And35And40PercentUnlessSomebodyHasToBeStarved) {
  const std::vector<Eigen::Vector3d> uavs{{0, 0, 0}, {10, 0, 0}, {20, 0, 0}};
  const auto elements = [&](int first, int second, int third) {
    std::vector<Eigen::Vector3d> all(first, uavs[0]);
    all.insert(all.end(), second, uavs[1]);
    all.insert(all.end(), third, uavs[2]);
    return all;
  };
  EXPECT_TRUE(Unbalanced(elements(25, 35, 40), uavs));
  EXPECT_FALSE(Unbalanced(elements(25, 35, 40), uavs, 0.5));
  EXPECT_FALSE(Unbalanced(elements(13, 40, 47), uavs, 0.5));
  EXPECT_TRUE(Unbalanced(elements(12, 41, 47), uavs, 0.5));  // less than half of 25
}

TEST(Balance, IsNeverCorrectedForOneUavOrFewElements) {
  const std::vector<Eigen::Vector3d> pair{{0, 0, 0}, {10, 0, 0}};
  EXPECT_FALSE(Unbalanced(std::vector<Eigen::Vector3d>(7, pair[0]), pair));
  EXPECT_TRUE(Unbalanced(std::vector<Eigen::Vector3d>(8, pair[0]), pair));
  EXPECT_FALSE(Unbalanced(std::vector<Eigen::Vector3d>(100, pair[0]), {pair[0]}));
}

}  // namespace
}  // namespace citrine::planner

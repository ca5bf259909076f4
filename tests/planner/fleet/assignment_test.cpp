#include "planner/fleet/assignment.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "core/random.h"

namespace citrine::planner {
namespace {

TEST(Assign, IsAsCheapAsTheBestOfAllPermutations) {
  Random random(3);
  for (int trial = 0; trial < 300; ++trial) {
    const int n = 1 + static_cast<int>(random.Below(6));
    Eigen::MatrixXd cost(n, n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) cost(i, j) = trial % 2 ? random.Uniform(0, 50) : random.Below(5);
    std::vector<int> order(n);
    std::iota(order.begin(), order.end(), 0);
    double best = 1e9;
    do {
      double sum = 0;
      for (int i = 0; i < n; ++i) sum += cost(i, order[i]);
      best = std::min(best, sum);
    } while (std::next_permutation(order.begin(), order.end()));
    const std::vector<int> column_of = Assign(cost);
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += cost(i, column_of[i]);
    ASSERT_NEAR(sum, best, 1e-9);
    ASSERT_TRUE(std::is_permutation(column_of.begin(), column_of.end(), order.begin()));
  }
}

}  // namespace
}  // namespace citrine::planner

#include "planner/view/groups.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace citrine::planner {
namespace {

Element At(const Eigen::Vector3d& p_W) {
  Element element;
  element.p_W = p_W;
  return element;
}

TEST(GroupSizes, CountsWhatAChainOfTouchingCellsJoins) {
  const std::vector<int> sizes = GroupSizes({At({1, 1, 1}), At({3.8, 2.2, 0.4}), At({4.2, 5.8, -0.8}),
                                             At({9, 1, 1}), At({9.2, 1.2, 1}), At({-9, 0, 0})});
  EXPECT_EQ(sizes, (std::vector<int>{3, 3, 3, 2, 2, 1}));
}

TEST(GroupSizes, AgreesWithJoiningPairsUntilNothingChanges) {
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Element> elements;
    for (int i = 0; i < 60; ++i) {
      const double x = random.Uniform(-12, 12), y = random.Uniform(-12, 12);
      elements.push_back(At({x, y, random.Uniform(0, 6)}));
    }
    const auto touch = [](const Element& a, const Element& b) {
      const Eigen::Vector3d d = (a.p_W / 2).array().floor() - (b.p_W / 2).array().floor();
      return d.cwiseAbs().maxCoeff() < 1.5;
    };
    std::vector<std::size_t> group(elements.size());
    for (std::size_t i = 0; i < group.size(); ++i) group[i] = i;
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < group.size(); ++i)
        for (std::size_t j = 0; j < group.size(); ++j)
          if (group[j] > group[i] && touch(elements[i], elements[j])) group[j] = group[i], changed = true;
    }
    const std::vector<int> sizes = GroupSizes(elements);
    for (std::size_t i = 0; i < group.size(); ++i)
      EXPECT_EQ(sizes[i], std::count(group.begin(), group.end(), group[i]));
  }
}

}  // namespace
}  // namespace citrine::planner

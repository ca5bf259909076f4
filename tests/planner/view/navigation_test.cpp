#include "planner/view/navigation.h"

#include <gtest/gtest.h>

namespace citrine::planner {
namespace {

TEST(Navigation, AlignmentFallsFromOneAheadToZeroBehind) {
  EXPECT_NEAR(Alignment({2, 0, 0}, {5, 0, 0}), 1, 1e-12);
  EXPECT_NEAR(Alignment({2, 0, 0}, {0, 1, 0}), 0.5, 1e-12);
  EXPECT_NEAR(Alignment({2, 0, 0}, {-5, 0, 0}), 0, 1e-12);
  EXPECT_EQ(Alignment({0.05, 0, 0}, {-5, 0, 0}), 1);
}

TEST(Navigation, ScoresAreTheNearestDistanceOverEachTimesItsAlignment) {
  std::vector<View> views(3);
  views[0].p_W = {4, 0, 0};
  views[1].p_W = {0, 8, 0};
  views[2].p_W = {0, 0, 0};
  const std::vector<double> scores = NavigationScores(views, {0, 0, 0}, {1, 0, 0}, 0.25);
  EXPECT_NEAR(scores[0], 0.25 / 4, 1e-12);
  EXPECT_NEAR(scores[1], 0.5 * 0.25 / 8, 1e-12);
  EXPECT_NEAR(scores[2], 1, 1e-12);  // no nearer than a voxel, in both places
}

}  // namespace
}  // namespace citrine::planner

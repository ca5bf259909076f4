#include "planner/view/shortlist.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace citrine::planner {
namespace {

/// Views a metre apart from x = 20 m to 30 m, and a single one at x = 3 m.
class Shortlist : public ::testing::Test {
 protected:
  Shortlist() {
    views_.push_back({.p_W = {3, 2, 0}});
    for (int x = 20; x < 30; ++x) views_.push_back({.p_W = Eigen::Vector3d(x, 2, 0)});
  }
  std::vector<double> Left(const Eigen::Vector3d& p_W, double hop_m) const {
    std::vector<View> views = views_;
    LeaveNearOnes(views, p_W, hop_m);
    std::vector<double> x;
    for (const View& view : views) x.push_back(view.p_W.x());
    return x;
  }
  std::vector<View> views_;
};

using ::testing::AnyOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Ge;
using ::testing::Le;
using ::testing::SizeIs;

TEST_F(Shortlist, IsAllOfTheViewsWhereNoRuleIsSet) { EXPECT_THAT(Left({0, 2, 0}, 0), SizeIs(views_.size())); }

TEST_F(Shortlist, LeavesNearViewsOutWhereTheSurfaceGoesOn) {
  EXPECT_THAT(Left({18, 2, 0}, 4), Each(AnyOf(Le(3), Ge(22))));
  EXPECT_THAT(Left({29.5, 2, 0}, 20), SizeIs(views_.size() - 10));
  EXPECT_THAT(Left({3, 2, 0}, 2.5), SizeIs(views_.size()));  // nothing within two hops
}

}  // namespace
}  // namespace citrine::planner

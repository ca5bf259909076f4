#include "planner/view/shortlist.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace citrine::planner {
namespace {

/// A wall of 100 elements from x = 20 m on, and a single one at x = 3 m; a view stands 2 m beside every
/// tenth.
class Shortlist : public ::testing::Test {
 protected:
  Shortlist() {
    Add({3, 0, 0});
    for (int i = 0; i < 100; ++i) Add({20 + 0.1 * i, 0, 0});
    for (std::size_t i = 0; i < elements_.size(); i += 10)
      views_.push_back({.p_W = elements_[i].p_W + Eigen::Vector3d(0, 2, 0), .element = elements_[i].linear});
  }
  void Add(const Eigen::Vector3d& p_W) {
    Element element;
    element.linear = static_cast<std::uint32_t>(10 * elements_.size());
    element.p_W = p_W;
    elements_.push_back(element);
  }
  std::vector<double> Left(const Eigen::Vector3d& p_W, const ShortlistRules& rules) const {
    std::vector<View> views = views_;
    Shorten(views, elements_, p_W, rules);
    std::vector<double> x;
    for (const View& view : views) x.push_back(view.p_W.x());
    return x;
  }
  std::vector<Element> elements_;
  std::vector<View> views_;
};

using ::testing::AnyOf;
using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Ge;
using ::testing::Le;
using ::testing::SizeIs;

TEST_F(Shortlist, IsAllOfTheViewsWhereNoRuleIsSet) {
  EXPECT_THAT(Left({0, 2, 0}, {}), SizeIs(views_.size()));
}

TEST_F(Shortlist, IsWhatSmallGroupsNearbyNeedBeforeTheUavGoesOn) {
  EXPECT_THAT(Left({0, 2, 0}, {.tidy_m = 5, .leftover_elements = 20}), ElementsAre(3));
  EXPECT_THAT(Left({0, 2, 0}, {.tidy_m = 5, .leftover_elements = 200}),
              ElementsAre(3));  // not 20 m for the rest
  EXPECT_THAT(Left({10, 2, 0}, {.tidy_m = 5, .leftover_elements = 20}), SizeIs(views_.size()));  // too far
  EXPECT_THAT(Left({20, 2, 0}, {.tidy_m = 5, .leftover_elements = 20}),
              SizeIs(views_.size()));  // a large one
}

TEST_F(Shortlist, LeavesNearViewsOutWhereTheSurfaceGoesOn) {
  EXPECT_THAT(Left({18, 2, 0}, {.hop_min_m = 4}), Each(AnyOf(Le(3), Ge(22))));
  EXPECT_THAT(Left({29.5, 2, 0}, {.hop_min_m = 20}), SizeIs(views_.size() - 10));
  EXPECT_THAT(Left({3, 2, 0}, {.hop_min_m = 2.5}), SizeIs(views_.size()));  // nothing within two hops
}

}  // namespace
}  // namespace citrine::planner

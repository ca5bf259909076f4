#include "planner/view/rated_views.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/trajectory/path.h"
#include "planner/view/well_seen.h"
#include "tests/support/random_map.h"

namespace citrine::planner {
namespace {

/// The patches of a random map, all of whose elements are to be seen.
class RatedViewsTest : public ::testing::Test {
 protected:
  RatedViewsTest() {
    ActiveSurface surface(world.map.grid(), world.map.quantisation(), QualityGoals());
    surface.Update(world.map);
    elements = ListElements(world.map, surface, [](std::uint32_t) { return false; });
    patches = PatchesOf(elements);
  }
  std::vector<View> Views(const Patch& patch, const std::vector<View>& own = {}) const {
    const auto own_views = [&](const std::vector<std::size_t>& which) {
      std::vector<View> views;
      for (const View& view : own)
        if (std::any_of(which.begin(), which.end(),
                        [&](std::size_t i) { return elements[i].linear == view.element; }))
          views.push_back(view);
      return views;
    };
    return RatedViews(world.map, window, elements, patch, own_views, allowed, p_W);
  }
  int Settled(const Patch& patch, const Eigen::Vector3d& view_W) const {
    return static_cast<int>(std::count_if(patch.elements.begin(), patch.elements.end(), [&](std::size_t i) {
      return WellSeen(world.map, elements[i], window, view_W);
    }));
  }

  testing::RandomMap world{33, {16, 12, 8}, 3};
  SensorWindow window{LidarModel()};
  std::vector<Element> elements;
  std::vector<Patch> patches;
  std::function<bool(const Eigen::Vector3d&)> allowed = [](const Eigen::Vector3d& p) { return p.z() > 1; };
  Eigen::Vector3d p_W{2, 2, 3};
};

TEST_F(RatedViewsTest, PatchesHoldEveryElementOnceAndNoneIsWiderThanACell) {
  std::multiset<std::size_t> all;
  for (const Patch& patch : patches)
    for (const std::size_t i : patch.elements) {
      all.insert(i);
      EXPECT_LE((elements[i].p_W - patch.centre_W).cwiseAbs().maxCoeff(), 5.0);
    }
  EXPECT_EQ(all.size(), elements.size());
  EXPECT_EQ(std::set<std::size_t>(all.begin(), all.end()).size(), elements.size());
}

TEST_F(RatedViewsTest, EachSettlesSomethingOfItsPatchFromWhereAUavMayStand) {
  int made = 0;
  for (const Patch& patch : patches)
    for (const View& view : Views(patch)) {
      EXPECT_TRUE(allowed(view.p_W));
      EXPECT_GE(Settled(patch, view.p_W), 1);
      const auto element = std::find_if(elements.begin(), elements.end(),
                                        [&](const Element& e) { return e.linear == view.element; });
      ASSERT_NE(element, elements.end());
      EXPECT_TRUE(WellSeen(world.map, *element, window, view.p_W));
      ++made;
    }
  EXPECT_GT(made, 20);
}

TEST_F(RatedViewsTest, NoPoseOfTheLatticeSettlesFarMoreForTheWay) {
  // Brute force over the lattice, element by element. The rating counts elements side by side as one, so that
  // the best is only nearly the best; where a patch has few elements they are most often counted exactly.
  int patches_tried = 0;
  for (const Patch& patch : patches) {
    const std::vector<View> views = Views(patch);
    if (views.empty() || patch.elements.size() < 20) continue;
    const auto rate = [&](const Eigen::Vector3d& view_W) {
      int settled = 0;
      for (const Element& e : elements) settled += WellSeen(world.map, e, window, view_W);
      return settled / ((view_W - p_W).norm() + 1.5);
    };
    double best = 0;
    const Eigen::Vector3d first_W = world.map.grid().Centre(world.map.grid().inside_min());
    for (double x = first_W.x(); x < 16; x += 1)
      for (double y = first_W.y(); y < 12; y += 1)
        for (double z = first_W.z(); z < 8; z += 0.5)
          if (allowed({x, y, z}) && Settled(patch, {x, y, z}) > 0) best = std::max(best, rate({x, y, z}));
    EXPECT_GE(rate(views.front().p_W), 0.6 * best);
    if (++patches_tried == 4) break;
  }
  EXPECT_GE(patches_tried, 2);
}

TEST_F(RatedViewsTest, OwnViewsAreAskedForOnlyWhereNoPoseSettles) {
  const Eigen::Vector3d first_W = world.map.grid().Centre(world.map.grid().inside_min());
  const auto is_settled = [&](const Element& e) {
    for (double x = first_W.x(); x < 16; x += 1)
      for (double y = first_W.y(); y < 12; y += 1)
        for (double z = first_W.z(); z < 8; z += 0.5) {
          const Eigen::Vector3d pose_W(x, y, z);
          const bool near = (pose_W - e.p_W).norm() <= e.d_star_m - kReached_m;
          if (near && allowed(pose_W) && WellSeen(world.map, e, window, pose_W)) return true;
        }
    return false;
  };
  std::size_t asked = 0, all = 0;
  for (const Patch& patch : patches) {
    const auto own_views = [&](const std::vector<std::size_t>& which) {
      for (const std::size_t i : which) EXPECT_FALSE(is_settled(elements[i])) << i;
      asked += which.size();
      return std::vector<View>{};
    };
    RatedViews(world.map, window, elements, patch, own_views, allowed, p_W);
    all += patch.elements.size();
  }
  EXPECT_GT(asked, 0u);
  EXPECT_LT(asked, all);
}

TEST_F(RatedViewsTest, AnElementThatALookFailedToSettleIsLookedAtFromItsOwnView) {
  Patch patch{elements[5].p_W, {5}};
  elements[5].attempts = 1;
  const View own{.p_W = {3, 3, 3}, .element = elements[5].linear};
  EXPECT_THAT(Views(patch), ::testing::IsEmpty());
  const std::vector<View> views = Views(patch, {own});
  ASSERT_EQ(views.size(), 1u);
  EXPECT_EQ(views[0].p_W, own.p_W);
}

}  // namespace
}  // namespace citrine::planner

#include "planner/view/view_score.h"

#include <gtest/gtest.h>

#include "tests/support/random_map.h"

namespace citrine::planner {
namespace {

TEST(BestView, IsTheArgumentOfTheMaximumThatAPlainDoubleLoopFinds) {
  for (const std::uint64_t seed : {21, 22, 23, 24}) {
    testing::RandomMap world(seed);
    ActiveSurface surface(world.map.grid(), world.map.quantisation(), QualityGoals());
    surface.Update(world.map);
    const std::vector<Element> elements =
        ListElements(world.map, surface, [](std::uint32_t v) { return v % 5 != 0; });
    const SensorWindow window{LidarModel()};
    const InformationGain gain(world.map, elements, window, 0.5);
    for (const double alpha : {0.25, 1.0, 4.0}) {
      std::vector<ViewTerms> views(80);
      for (ViewTerms& view : views) {
        view.p_W = world.Point({12, 10, 8});
        view.navigation = world.random().Uniform();
        view.coordination = world.random().Below(3) / 2.0;
      }
      for (std::size_t i = 1; i < views.size(); i += 2)  // as neighbours share a bound
        views[i].p_W = views[i - 1].p_W + world.Point({0.4, 0.4, 0.4});
      views[17] = views[5];  // a tie
      const ScoreWeights weights{alpha, 1, 2};

      int most = 0;
      std::vector<Gain> all;
      for (const ViewTerms& view : views)
        all.push_back(gain.Evaluate(view.p_W)), most = std::max(most, all.back().visible);
      std::vector<bool> out(views.size());
      BestView best(gain, views, weights);
      for (int round = 0; round < 10; ++round) {
        std::size_t expected = views.size();
        double highest = -1;
        for (std::size_t i = 0; i < views.size(); ++i) {
          const double total = alpha * (all[i].sum / most) + views[i].navigation + 2 * views[i].coordination;
          if (!out[i] && total > highest) highest = total, expected = i;
        }
        const std::optional<std::size_t> found = best.Next();
        ASSERT_TRUE(found);
        ASSERT_EQ(*found, expected);
        best.Discard(expected);
        out[expected] = true;
      }
      EXPECT_EQ(best.MostVisible(), most);
      for (std::size_t i = 0; i < views.size(); ++i)
        EXPECT_EQ(best.ScoreOf(i).information, all[i].sum / most);  // the same sum in the same order
    }
  }
}

TEST(BestView, IsFoundWithoutCountingWhatEveryViewSees) {
  testing::RandomMap world(25);
  ActiveSurface surface(world.map.grid(), world.map.quantisation(), QualityGoals());
  surface.Update(world.map);
  const std::vector<Element> elements = ListElements(world.map, surface, [](std::uint32_t) { return false; });
  const SensorWindow window{LidarModel()};
  const InformationGain gain(world.map, elements, window, 0.5);
  std::vector<ViewTerms> views(200);
  for (ViewTerms& view : views)
    view = {world.Point({12, 10, 8}), world.random().Uniform(), world.random().Uniform()};
  BestView best(gain, views, {});
  ASSERT_TRUE(best.Next());
  EXPECT_LT(best.evaluated(), 100);
}

TEST(BestView, IsNoneOnceAllAreDiscarded) {
  testing::RandomMap world(3);
  const SensorWindow window{LidarModel()};
  const InformationGain gain(world.map, {}, window, 0.5);
  BestView best(gain, {ViewTerms{}}, {});
  ASSERT_EQ(best.Next(), 0u);
  best.Discard(0);
  EXPECT_FALSE(best.Next());
}

}  // namespace
}  // namespace citrine::planner

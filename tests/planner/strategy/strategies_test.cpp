#include "planner/strategy/strategies.h"

#include <gtest/gtest.h>

#include "tests/support/random_map.h"

namespace citrine::planner {
namespace {

TEST(Strategies, AreMadeByNameAndAnUnknownNameIsRefusedWithTheKnownOnes) {
  PlannerSection config;
  for (const std::string& name : StrategyNames()) {
    config.strategy = name;
    EXPECT_NE(MakeStrategy(config), nullptr);
  }
  config.strategy = "clairvoyant";
  try {
    MakeStrategy(config);
    FAIL() << "accepted";
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("clairvoyant"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("quality_adaptive"), std::string::npos);
  }
}

class ChoiceTest : public ::testing::Test {
 protected:
  ChoiceTest() {
    views[0].p_W = {6, 5, 3};
    views[1].p_W = {2, 5, 3};
    views[2].p_W = {11, 5, 3};
    for (View& view : views) view.element_W = view.p_W;
  }
  std::size_t Choose(const std::string& name, const std::vector<Eigen::Vector3d>* centroids = nullptr,
                     int reject = 0) {
    PlannerSection config;
    config.strategy = name;
    const Situation situation{world.map, goals,     window,         0.5,      elements, views, 1,
                              {3, 5, 3}, {0, 0, 0}, {{40, 40, 40}}, centroids};
    const auto choice = MakeStrategy(config)->Choose(situation, [&](const View&) { return reject-- <= 0; });
    return choice.value_or(99);
  }
  testing::RandomMap world{1};
  QualityGoals goals;
  SensorWindow window{LidarModel()};
  std::vector<Element> elements;
  std::vector<View> views{3};
};

TEST_F(ChoiceTest, TheNearestFrontierIsTheNearestView) {
  EXPECT_EQ(Choose("nearest_frontier"), 1u);
  EXPECT_EQ(Choose("nearest_frontier", nullptr, 1), 0u);
}

TEST_F(ChoiceTest, UnderACorrectionViewsOfElementsInTheOwnCellComeFirst) {
  EXPECT_EQ(Choose("quality_adaptive"), 1u);
  const std::vector<Eigen::Vector3d> centroids{{11, 5, 3}, {2, 5, 3}};  // UAV 1's cell is x > 6.5
  EXPECT_EQ(Choose("quality_adaptive", &centroids), 2u);
}

TEST_F(ChoiceTest, OffersTheNextBestUntilOneIsAccepted) {
  EXPECT_EQ(Choose("quality_adaptive", nullptr, 2), 2u);
  EXPECT_EQ(Choose("quality_adaptive", nullptr, 3), 99u);
}

}  // namespace
}  // namespace citrine::planner

#include "planner/strategy/view_planner.h"

#include <gtest/gtest.h>

#include <cmath>

#include "planner/trajectory/minimum_jerk_spline.h"
#include "tests/support/random_map.h"

namespace citrine::planner {
namespace {

constexpr Utime kStep = 20'000;

/// Planners of a fleet over a map that stays as it is; each step they hear what was said in the step before.
class ViewPlannerTest : public ::testing::Test {
 protected:
  void Add(int uavs, const std::vector<Eigen::Vector3d>& p_W) {
    config.mission.uavs = uavs;
    config.planner.balance = false;
    for (int uav = 1; uav <= uavs; ++uav) {
      planners.push_back(std::make_unique<ViewPlanner>(
          config, uav, world.map, surface,
          std::make_shared<ReachableSet>(world.map, config.uav.limits, config.planner.path_margin_m),
          [](const auto& start_W, const auto& goal_W, const auto&) -> std::optional<Path> {
            Path path;
            path.waypoints = {{start_W, 1}, {goal_W, 1}};
            return path;
          },
          [](const auto& from_W, const auto& to_W) -> Eigen::MatrixXd {
            return Eigen::MatrixXd::Ones(from_W.size(), to_W.size());
          }));
      states.emplace_back();
      states.back().X_WB.p = p_W[uav - 1];
    }
    statuses.resize(uavs);
    outcomes.resize(uavs);
    surface.Update(world.map);
    for (auto& planner : planners) planner->HearMap(0);
  }
  void Step() {
    const std::vector<FleetStatus> said = statuses;
    for (std::size_t i = 0; i < planners.size(); ++i) {
      for (std::size_t j = 0; j < planners.size(); ++j) {
        planners[i]->HearState(static_cast<int>(j) + 1, states[j], now);
        if (now > 0) planners[i]->HearStatus(static_cast<int>(j) + 1, said[j], now);
      }
      outcomes[i] = planners[i]->Tick(now, 1);
      statuses[i] = planners[i]->Status();
    }
    now += kStep;
  }

  testing::RandomMap world{33, {16, 12, 8}, 3};
  MissionConfig config;
  ActiveSurface surface{world.map.grid(), world.map.quantisation(), config.quality_goals()};
  Utime now = 0;
  std::vector<std::unique_ptr<ViewPlanner>> planners;
  std::vector<UavState> states;
  std::vector<FleetStatus> statuses;
  std::vector<ViewPlanner::Outcome> outcomes;

  Eigen::Vector3d FreePlace(int skip = 0) {
    const SafeSpace space(world.map, config.uav.limits, 0.3);
    for (double x = 2; x < 14; x += 0.5)
      for (double y = 2; y < 10; y += 0.5)
        if (space.Slack({x, y, 3}) > 0 && skip-- <= 0) return {x, y, 3};
    return Eigen::Vector3d::Zero();
  }
};

TEST_F(ViewPlannerTest, TheDecisionTakesEffectOneLatencyAfterItsTrigger) {
  Add(1, {FreePlace()});
  Step();
  EXPECT_EQ(statuses[0].activity, FleetStatus::Activity::kDeciding);
  for (int k = 1; k < 5; ++k) {
    Step();
    EXPECT_FALSE(outcomes[0].decided);
  }
  Step();
  EXPECT_TRUE(outcomes[0].decided);
  ASSERT_TRUE(outcomes[0].new_path);
  EXPECT_TRUE(statuses[0].has_goal);
  EXPECT_EQ(statuses[0].activity, FleetStatus::Activity::kFlying);
  EXPECT_TRUE(planners[0]->path()->waypoints.back().p_W.isApprox(statuses[0].goal_W));
}

TEST_F(ViewPlannerTest, PlannersTriggeredTogetherDecideInOrderOfId) {
  Add(2, {FreePlace(), FreePlace(40)});
  std::vector<Utime> decided(2, -1);
  for (int k = 0; k < 15; ++k) {
    Step();
    for (int i = 0; i < 2; ++i)
      if (outcomes[i].decided && decided[i] < 0) decided[i] = now;
  }
  ASSERT_GE(decided[0], 0);
  EXPECT_GT(decided[1], decided[0]);
  ASSERT_TRUE(statuses[0].has_goal && statuses[1].has_goal);
  EXPECT_GE((statuses[0].goal_W - statuses[1].goal_W).norm(), 2.5);  // two radii and half a metre
}

TEST_F(ViewPlannerTest, TheNextViewIsChosenInFlightAndFlownToThroughTheOneStillToBeLookedFrom) {
  Add(1, {FreePlace()});
  for (int k = 0; k < 6; ++k) Step();
  ASSERT_TRUE(statuses[0].has_goal);
  const Eigen::Vector3d first = statuses[0].goal_W;
  // 4 m behind the view, from where what it was made for is beyond d*; a trajectory of 1.3 s leads to it.
  const double yaw = statuses[0].goal_yaw_rad;
  const Eigen::Vector3d back = Eigen::Vector3d(std::cos(yaw), std::sin(yaw), 0) * -4;
  states[0].X_WB.p = first + back;
  Trajectory there;
  there.id = 1;
  there.path_id = planners[0]->path()->id;
  there.start = now;
  there.segments = {Quintic({first + back, -back, {0, 0, 0}}, {first}, 1.3)};
  planners[0]->HearTrajectory(there);
  do Step();
  while (!outcomes[0].new_path && now < FromSeconds(0.5));
  ASSERT_TRUE(outcomes[0].new_path);
  EXPECT_GT((statuses[0].goal_W - first).norm(), 0.5);
  const std::vector<Waypoint>& way = planners[0]->path()->waypoints;
  ASSERT_EQ(way.size(), 3);
  EXPECT_EQ(way[1].p_W, first);
  EXPECT_EQ(way[2].p_W, statuses[0].goal_W);
}

TEST_F(ViewPlannerTest, ViewsUpForChoiceAreOfElementsThatNoMateIsNearerTo) {
  config.planner.candidates = "patch";
  Add(2, {FreePlace(), FreePlace(40)});
  std::size_t views = 0;
  for (auto& planner : planners)
    planner->TellDecisions([&](const Decision& decision) {
      const Situation& at = decision.situation;
      for (const View& view : at.views)
        EXPECT_LE((view.element_W - at.p_W).norm(), (view.element_W - at.others_W.at(0)).norm());
      views += at.views.size();
    });
  for (int k = 0; k < 15; ++k) Step();
  EXPECT_GE(views, 2);
}

TEST_F(ViewPlannerTest, AllViewsAreUpForChoiceByThePapersLetter) {
  config.planner.candidates = "all";
  config.planner.hop_min_m = 0;
  Add(1, {FreePlace()});
  std::size_t up_for_choice = 0, candidates = 0;
  planners[0]->TellDecisions(
      [&](const Decision& decision) { up_for_choice = decision.situation.views.size(); });
  for (int k = 0; k < 6; ++k) {
    Step();
    if (outcomes[0].decided) candidates = outcomes[0].views;
  }
  EXPECT_GT(candidates, 20);
  EXPECT_EQ(up_for_choice, candidates);
}

TEST_F(ViewPlannerTest, ABlockedGoalIsNotChosenAgainForAWhile) {
  Add(1, {FreePlace()});
  for (int k = 0; k < 6; ++k) Step();
  const Eigen::Vector3d first = statuses[0].goal_W;
  FlightStatus flight;
  flight.phase = FlightStatus::Phase::kBlocked;
  flight.path_id = planners[0]->path()->id;
  planners[0]->HearFlight(flight);
  Step();
  EXPECT_FALSE(statuses[0].has_goal);
  for (int k = 0; k < 10; ++k) Step();
  ASSERT_TRUE(statuses[0].has_goal);
  EXPECT_GT((statuses[0].goal_W - first).norm(), 0.5);
}

TEST_F(ViewPlannerTest, AMissionWhoseMapNeverChangesEndsByItself) {
  config.planner.strays_m = 0;
  // Every goal is reached at once and no look ever helps: all elements are given up or unreachable in the
  // end.
  Add(1, {FreePlace()});
  int decisions = 0;
  Step();
  for (; now < FromSeconds(900) && !statuses[0].no_view_left;) {
    if (statuses[0].has_goal) states[0].X_WB.p = statuses[0].goal_W;
    Step();
    decisions += outcomes[0].decided;
  }
  EXPECT_TRUE(statuses[0].no_view_left) << statuses[0].elements_active << " active after " << decisions;
  EXPECT_EQ(statuses[0].elements_active, 0);
  EXPECT_GT(statuses[0].elements_given_up, 0);
  EXPECT_GT(statuses[0].elements_unreachable, 0) << statuses[0].elements_given_up << " given up after "
                                                 << decisions << " decisions and " << Seconds(now) << " s";
}

TEST_F(ViewPlannerTest, StraysAreLeftAndSaidToBeActive) {
  config.planner.strays_m = 3;
  Add(1, {FreePlace()});
  Step();
  for (; now < FromSeconds(900) && !statuses[0].no_view_left;) {
    if (statuses[0].has_goal) states[0].X_WB.p = statuses[0].goal_W;
    Step();
  }
  EXPECT_TRUE(statuses[0].no_view_left);
  EXPECT_GT(statuses[0].elements_active, 0);
}

}  // namespace
}  // namespace citrine::planner

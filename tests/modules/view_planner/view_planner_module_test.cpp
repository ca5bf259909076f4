#include "modules/view_planner/view_planner_module.h"

#include <limits>

#include <gtest/gtest.h>

#include "modules/codec/fleet_status.h"
#include "modules/codec/path.h"
#include "tests/support/yard_flight.h"

namespace citrine {
namespace {

/// The planner of UAV 1, which hovers for ever in a yard whose surfaces were all seen from too far.
class ViewPlannerOnTheBus : public ::testing::Test, protected test::YardFlight<ViewPlannerModule> {
 protected:
  ViewPlannerOnTheBus() { Begin(1); }

  void Hover() {
    SayMap();
    SayState(1);
    SayState(2);
    Tick();
  }
  std::vector<Path> Paths() {
    std::vector<Path> said;
    for (const auto& entry : paths_->Take()) said.push_back(Decode(entry.message));
    return said;
  }
  std::vector<FleetStatus> Statuses() {
    std::vector<FleetStatus> said;
    for (const auto& entry : statuses_->Take()) said.push_back(Decode(entry.message));
    return said;
  }

 private:
  std::shared_ptr<Inbox<citrine_lcm::path_t>> paths_ = peers.Hear(channels::kPath, 1);
  std::shared_ptr<Inbox<citrine_lcm::fleet_status_t>> statuses_ = peers.Hear(channels::kFleetStatus, 1);
};

TEST_F(ViewPlannerOnTheBus, SaysItsStatusFiveTimesASecondBeforeItKnowsAnything) {
  Fly(1);
  Statuses();
  Fly(2);
  const auto said = Statuses();
  EXPECT_EQ(said.size(), 10u);
  for (const FleetStatus& status : said) {
    EXPECT_FALSE(status.has_goal);
    EXPECT_FALSE(status.no_view_left) << "who has not seen a map does not know that there is nothing to see";
  }
  EXPECT_TRUE(Paths().empty());
}

TEST_F(ViewPlannerOnTheBus, SaysThePathToTheGoalThatItReserves) {
  Hover();
  Fly(1);
  const auto paths = Paths();
  const auto statuses = Statuses();
  ASSERT_FALSE(paths.empty());
  ASSERT_TRUE(statuses.back().has_goal);
  EXPECT_TRUE(paths.back().waypoints.front().p_W.isApprox(config.mission.spawns_m[0], 1e-6));
  EXPECT_TRUE(paths.back().waypoints.back().p_W.isApprox(statuses.back().goal_W, 1e-6));
  for (const Waypoint& waypoint : paths.back().waypoints)
    EXPECT_GT(scene.Distance(waypoint.p_W), config.uav.limits.radius_m) << waypoint.p_W.transpose();
}

TEST_F(ViewPlannerOnTheBus, RepeatsItsPathTwiceASecondUnderTheSameId) {
  Hover();
  Fly(1);
  const auto first = Paths();
  ASSERT_FALSE(first.empty());
  Fly(2);
  const auto repeated = Paths();
  EXPECT_EQ(repeated.size(), 4u);
  for (const Path& path : repeated) EXPECT_EQ(path.id, first.back().id);
}

TEST_F(ViewPlannerOnTheBus, DropsAndCountsAStateThatIsNoneAndGoesOn) {
  Hover();
  citrine_lcm::uav_state_t message = Encode(UavState());
  message.p_WB[0] = std::numeric_limits<double>::quiet_NaN();
  peers.Publish(channels::kUavState, 2, message);
  Fly(1);
  EXPECT_EQ(bus.counts().bad, 1);
  EXPECT_TRUE(Statuses().back().has_goal);
}

}  // namespace
}  // namespace citrine

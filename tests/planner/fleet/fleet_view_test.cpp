#include "planner/fleet/fleet_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace citrine::planner {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// What UAV 1 hears of UAV 2, which flies along x.
class FleetViewTest : public ::testing::Test {
 protected:
  void HearGoal(double x) {
    FleetStatus status;
    status.has_goal = true;
    status.goal_W = {x, 0, 0};
    fleet.Hear(2, status, now);
  }
  void FlyTo(double x) {
    for (; at < x; at += 0.1) {
      UavState state;
      state.X_WB.p = {at, 0, 0};
      fleet.Hear(2, state, now += 20'000);
    }
  }
  std::vector<double> Looks() {
    std::vector<double> x;
    for (const Eigen::Vector3d& look_W : fleet.TakeLooks()) x.push_back(look_W.x());
    return x;
  }

  FleetView fleet{1, 2};
  Utime now = 0;
  double at = 0;
};

TEST_F(FleetViewTest, AMateHasLookedFromAViewWhenItReachesIt) {
  HearGoal(4);
  FlyTo(3.5);
  EXPECT_THAT(Looks(), IsEmpty());
  FlyTo(4.5);
  EXPECT_THAT(Looks(), ElementsAre(4));
  EXPECT_THAT(Looks(), IsEmpty());
}

TEST_F(FleetViewTest, AViewThatIsFlownThroughOnTheWayToTheNextCountsToo) {
  HearGoal(4);
  FlyTo(3);
  HearGoal(8);
  FlyTo(9);
  EXPECT_THAT(Looks(), ElementsAre(4, 8));
}

TEST_F(FleetViewTest, AViewThatIsGivenUpIsNoLook) {
  HearGoal(-4);
  HearGoal(4);
  HearGoal(8);
  FlyTo(9);
  EXPECT_THAT(Looks(), ElementsAre(4, 8));
}

}  // namespace
}  // namespace citrine::planner

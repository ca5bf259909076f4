#include "modules/topdown_renderer/scene_hearer.h"

#include <gtest/gtest.h>

#include "modules/codec/fleet_assignment.h"
#include "modules/codec/fleet_status.h"
#include "tests/support/yard_flight.h"

namespace citrine {
namespace {

struct Watcher {
  explicit Watcher(const ModuleContext& context) : hearer(context) {}
  void Tick(const Step& step) { hearer.Update(step); }
  SceneHearer hearer;
};

/// Two UAVs, and a correction of their balance that holds for 20 s.
class SceneOfACorrection : public ::testing::Test, protected test::YardFlight<Watcher> {
 protected:
  static constexpr std::int64_t kPlan = 77;

  SceneOfACorrection() {
    Begin(0);
    Tick();
    SayCorrection();
    Fly(0.1);
  }
  void SayCorrection() {
    peers.Publish(channels::kFleetAssignment,
                  Encode(FleetAssignment{kPlan, 1, FromSeconds(20), 2, {{-2, 0, 2}, {2, 0, 2}}}));
  }
  void SayStatus(int uav, std::int64_t plan, int selections_left) {
    FleetStatus status;
    status.plan_id = plan;
    status.corrected_selections_left = selections_left;
    peers.Publish(channels::kFleetStatus, uav, Encode(status));
  }
  bool Marked(int uav) {
    return module->hearer.Finish().uavs[static_cast<std::size_t>(uav - 1)].centroid_W.has_value();
  }
};

TEST_F(SceneOfACorrection, MarksTheShareOfEachUntilItHasMadeItsSelections) {
  EXPECT_TRUE(Marked(1));
  EXPECT_TRUE(Marked(2));
  SayStatus(1, kPlan, 0);
  SayStatus(2, kPlan, 1);
  Fly(0.1);
  EXPECT_FALSE(Marked(1));
  EXPECT_TRUE(Marked(2));
  SayCorrection();  // as it is said again at 2 Hz
  Fly(0.1);
  EXPECT_FALSE(Marked(1));
  EXPECT_TRUE(Marked(2));
}

TEST_F(SceneOfACorrection, MarksNobodyWhoKnowsANewerOne) {
  SayStatus(2, kPlan + 1, 2);
  Fly(0.1);
  EXPECT_TRUE(Marked(1));
  EXPECT_FALSE(Marked(2));
}

TEST_F(SceneOfACorrection, MarksNothingOnceItsTimeHasRunOut) {
  Fly(19.5);
  EXPECT_TRUE(Marked(1));
  Fly(1);
  EXPECT_FALSE(Marked(1));
  EXPECT_FALSE(Marked(2));
}

TEST_F(SceneOfACorrection, MarksNothingOnceTheMissionIsOver) {
  Tick(true);
  EXPECT_FALSE(Marked(1));
  EXPECT_FALSE(Marked(2));
}

}  // namespace
}  // namespace citrine

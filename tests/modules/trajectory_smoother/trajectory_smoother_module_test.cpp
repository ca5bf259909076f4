#include "modules/trajectory_smoother/trajectory_smoother_module.h"

#include <limits>

#include <gtest/gtest.h>

#include "modules/codec/flight_status.h"
#include "modules/codec/path.h"
#include "modules/codec/trajectory.h"
#include "tests/support/yard_flight.h"

namespace citrine {
namespace {

/// The smoother of UAV 1, which hovers in a yard that is known.
class TrajectorySmoother : public ::testing::Test, protected test::YardFlight<TrajectorySmootherModule> {
 protected:
  TrajectorySmoother() { Begin(1); }

  void Hover() {
    SayMap();
    SayState(1);
    Tick();
  }
  Path ToTheEast(std::int64_t id) const {
    Path path;
    path.id = id;
    path.waypoints = {{config.mission.spawns_m[0], 1.4}, {{0, -5, 2.5}, 1.4}};
    return path;
  }
  std::vector<Trajectory> Said() {
    std::vector<Trajectory> said;
    for (const auto& entry : trajectories_->Take()) said.push_back(Decode(entry.message));
    return said;
  }
  std::vector<FlightStatus> SaidOfItself() {
    std::vector<FlightStatus> said;
    for (const auto& entry : statuses_->Take()) said.push_back(Decode(entry.message));
    return said;
  }

 private:
  std::shared_ptr<Inbox<citrine_lcm::trajectory_t>> trajectories_ = peers.Hear(channels::kTrajectory, 1);
  std::shared_ptr<Inbox<citrine_lcm::flight_status_t>> statuses_ = peers.Hear(channels::kFlightStatus, 1);
};

TEST_F(TrajectorySmoother, SaysNoTrajectoryBeforeItKnowsWhereItIs) {
  SayMap();
  SayState(2);
  Fly(1);
  EXPECT_TRUE(Said().empty());
  SayState(1);
  Fly(0.1);
  const auto said = Said();
  ASSERT_FALSE(said.empty());
  EXPECT_TRUE(said[0].At(now()).p_W.isApprox(config.mission.spawns_m[0]));
}

TEST_F(TrajectorySmoother, RepeatsItsTrajectoryTwiceASecondUnderTheSameId) {
  Hover();
  Fly(1);
  const auto before = Said();
  ASSERT_FALSE(before.empty());
  Fly(3);
  const auto repeated = Said();
  EXPECT_EQ(repeated.size(), 6u);
  for (const Trajectory& trajectory : repeated) EXPECT_EQ(trajectory.id, before[0].id);
}

TEST_F(TrajectorySmoother, SaysHowItFliesFiveTimesASecond) {
  Hover();
  Fly(1);
  SaidOfItself();
  Fly(2);
  const auto said = SaidOfItself();
  EXPECT_EQ(said.size(), 10u);
  for (const FlightStatus& status : said) EXPECT_EQ(status.phase, FlightStatus::Phase::kWaiting);
}

TEST_F(TrajectorySmoother, FliesThePathThatItHears) {
  Hover();
  peers.Publish(channels::kPath, 1, Encode(ToTheEast(7)));
  Fly(0.1);
  const auto said = Said();
  ASSERT_FALSE(said.empty());
  EXPECT_EQ(said.back().path_id, 7);
  EXPECT_LT((said.back().At(said.back().end()).p_W - Eigen::Vector3d(0, -5, 2.5)).norm(), 0.25);
  EXPECT_EQ(SaidOfItself().back().phase, FlightStatus::Phase::kTracking);
  Fly(said.back().duration_s());
  EXPECT_EQ(SaidOfItself().back().phase, FlightStatus::Phase::kReached);
}

TEST_F(TrajectorySmoother, IgnoresAPathThatItKnowsAndThoseOfOthers) {
  Hover();
  peers.Publish(channels::kPath, 1, Encode(ToTheEast(7)));
  Fly(0.1);
  const std::int64_t id = Said().back().id;
  peers.Publish(channels::kPath, 1, Encode(ToTheEast(7)));
  peers.Publish(channels::kPath, 2, Encode(ToTheEast(8)));
  Fly(0.5);
  for (const Trajectory& trajectory : Said()) EXPECT_EQ(trajectory.id, id);
}

TEST_F(TrajectorySmoother, DropsAndCountsAPathThatIsNone) {
  Hover();
  citrine_lcm::path_t message = Encode(ToTheEast(7));
  message.x_W[1] = std::numeric_limits<double>::quiet_NaN();
  peers.Publish(channels::kPath, 1, message);
  Fly(0.5);
  EXPECT_EQ(bus.counts().bad, 1);
  EXPECT_EQ(SaidOfItself().back().phase, FlightStatus::Phase::kWaiting);
}

}  // namespace
}  // namespace citrine

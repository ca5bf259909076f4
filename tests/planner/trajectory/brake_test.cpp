#include "planner/trajectory/brake.h"

#include <gtest/gtest.h>

#include <cmath>

#include "planner/trajectory/minimum_jerk_spline.h"
#include "planner/trajectory/trajectory_check.h"
#include "planner/trajectory/trajectory_cut.h"
#include "planner/trajectory/yaw.h"
#include "tests/planner/path/synthetic_map.h"

namespace citrine::planner {
namespace {

using Eigen::Vector3d;

/// A curved motion that cruises near the speed limit between rests.
Trajectory Flight() {
  MinimumJerkSpline spline;
  std::vector<Knot> knots(5);
  knots[0].p = {3, 6, 4};
  knots[1].p = {6, 6.5, 4};
  knots[2].p = {11, 7, 4.2};
  knots[3].p = {17, 6.4, 4};
  knots[4].p = {20, 6, 4};
  spline.Solve(knots, {1.6, 1.5, 1.8, 1.6});
  Trajectory flight;
  flight.start = 1'000'000;
  flight.segments = spline.Segments();
  return flight;
}

class BrakeAlongTest : public testing::TestWithParam<Braking> {};

TEST_P(BrakeAlongTest, StaysOnTheWayWithinTheLimitsAndContinuesExactly) {
  const PlanningMap map = MapOf({24, 12, 8}, EmptySpace);
  FlightScene scene;
  scene.map = &map;
  const Trajectory flight = Flight();
  for (const double at_s : {0.3, 1.2, 2.5, 3.3, 5.0}) {
    const Utime at = flight.start + FromSeconds(at_s);
    const Trajectory brake =
        Splice(flight, at - 100'000, at, BrakeAlong(flight, at, scene.limits, GetParam()));
    const TrajectoryPoint before = flight.At(at), after = brake.At(at);
    EXPECT_LT((before.p_W - after.p_W).norm(), 1e-9);
    EXPECT_LT((before.v_W - after.v_W).norm(), 1e-9);
    EXPECT_LT((before.a_W - after.a_W).norm(), 1e-9);
    const auto violation = FindViolation(brake, at - 100'000, scene);
    EXPECT_FALSE(violation) << violation->Reason() << " at " << at_s;
    for (Utime t = at; t < brake.end(); t += 20'000) {
      double nearest = 1e9;
      for (Utime s = at; s < flight.end(); s += 2'000)
        nearest = std::min(nearest, (flight.At(s).p_W - brake.At(t).p_W).norm());
      EXPECT_LT(nearest, 0.006);  // samples of the flight lie 9 mm apart at 4.5 m/s
    }
  }
}

TEST_P(BrakeAlongTest, BrakesNoHarderThanTheLimitWhereTheMotionSlowsDownByItself) {
  const PlanningMap map = MapOf({40, 12, 8}, EmptySpace);
  FlightScene scene;
  scene.map = &map;
  // From 4.5 to 0.5 m/s: a parabola of 1.5 dv / T = 4.7 m/s^2 at its peak.
  constexpr double kFast_mps = 4.5, kSlow_mps = 0.5, kPeak_mps2 = 4.7;
  const double T = 1.5 * (kFast_mps - kSlow_mps) / kPeak_mps2;
  const Vector3d bend(3 + (kFast_mps + kSlow_mps) / 2 * T, 6, 4), end = bend + Vector3d(20 * kSlow_mps, 0, 0);
  Trajectory slowing;
  slowing.segments = {Quintic({{3, 6, 4}, {kFast_mps, 0, 0}}, {bend, {kSlow_mps, 0, 0}}, T),
                      Quintic({bend, {kSlow_mps, 0, 0}}, {end, {kSlow_mps, 0, 0}}, 20),
                      Quintic({end, {kSlow_mps, 0, 0}}, {end + Vector3d(0.5, 0, 0)}, 2)};
  for (Utime at = 0; at < FromSeconds(T); at += 100'000) {
    const Trajectory brake = Splice(slowing, at, at, BrakeAlong(slowing, at, scene.limits, GetParam()));
    const auto violation = FindViolation(brake, at, scene);
    EXPECT_FALSE(violation) << violation->Reason() << " at " << Seconds(at);
  }
}

INSTANTIATE_TEST_SUITE_P(Both, BrakeAlongTest, testing::Values(Braking::kGentle, Braking::kHard));

TEST(BrakeAlong, StopsFromFullSpeedInTheDistanceThatItPromises) {
  const Trajectory onward = Onward({{0, 0, 0}, {4.5, 0, 0}}, 0);
  Trajectory brake;
  brake.segments = BrakeAlong(onward, 0, {}, Braking::kHard);
  EXPECT_NEAR(brake.At(brake.end()).p_W.x(), StoppingDistance(4.5, {}), 1e-3);
  EXPECT_LT(StoppingDistance(4.5, {}), 2.8);
  EXPECT_GT(StoppingDistance(4.5, {}), 4.5 * 4.5 / (2 * 4.8));  // nothing stops faster
  brake.segments = BrakeAlong(onward, 0, {}, Braking::kGentle);
  EXPECT_LT(brake.At(brake.end()).p_W.x(), 3.52);
}

TEST(Cut, ReproducesTheMotionIncludingTheRestAroundIt) {
  const Trajectory flight = Flight();
  Trajectory cut;
  cut.start = flight.start - 500'000;
  const Utime end = flight.end() + 700'000;
  cut.segments = Cut(flight, cut.start, end);
  for (Utime t = cut.start; t < end; t += 37'000)
    EXPECT_LT((cut.At(t).p_W - flight.At(t).p_W).norm(), 1e-9) << t;
  EXPECT_NEAR(cut.duration_s(), Seconds(end - cut.start), 2e-6);
}

TEST(Yaw, TurnsTheShortWayAndNoFasterThanNinetyDegreesASecond) {
  Trajectory flight = Flight();
  AddYaw(3.0, 0.2, -2.5, &flight.segments);
  EXPECT_NEAR(flight.At(flight.end()).yaw_rad, 2 * EIGEN_PI - 2.5, 1e-9);
  AddYaw(0, 0, 3.1, &flight.segments);
  double fastest = 0;
  for (Utime t = flight.start; t < flight.end(); t += 5'000)
    fastest = std::max(fastest, std::abs(flight.At(t).yaw_rate_radps));
  EXPECT_LE(fastest, kYawRateMax_radps + 1e-9);
  flight.segments.resize(1);  // 1.6 s are too short for half a turn
  AddYaw(0, 0, 3.1, &flight.segments);
  EXPECT_NEAR(flight.At(flight.end()).yaw_rad, kYawRateMax_radps * 1.6 / 1.875, 1e-6);
}

TEST(FindViolation, SeesEveryKindOfWrong) {
  const PlanningMap map = MapOf(
      {24, 12, 8}, [](const Vector3d& p) { return p.y() - 4; }, [](const Vector3d& p) { return p.x() < 16; });
  FlightScene scene;
  scene.map = &map;
  using Kind = Violation::Kind;
  const auto leg = [](const Vector3d& from, const Vector3d& to, double T) {
    Trajectory motion;
    motion.segments = {Quintic({from}, {to}, T)};
    return motion;
  };
  const auto kind = [&](const Trajectory& motion) {
    const auto violation = FindViolation(motion, 0, scene);
    return violation ? static_cast<int>(violation->kind) : -1;
  };
  EXPECT_EQ(kind(leg({3, 8, 4}, {9, 8, 4}, 4)), -1);
  EXPECT_EQ(kind(leg({3, 8, 4}, {14, 8, 4}, 4)), static_cast<int>(Kind::kSpeed));
  EXPECT_EQ(kind(leg({3, 8, 4}, {4, 8, 4}, 0.8)), static_cast<int>(Kind::kAcceleration));
  EXPECT_EQ(kind(leg({3, 8, 4}, {3, 4.8, 4}, 4)), static_cast<int>(Kind::kOccupied));
  EXPECT_EQ(kind(leg({9, 8, 4}, {15.5, 8, 4}, 6)), static_cast<int>(Kind::kUnknown));
  EXPECT_EQ(kind(leg({3, 8, 4}, {3, 8, 8.2}, 4)), static_cast<int>(Kind::kVolume));
  Trajectory jump = leg({3, 8, 4}, {6, 8, 4}, 4);
  jump.segments.push_back(leg({6.1, 8, 4}, {7, 8, 4}, 4).segments[0]);
  EXPECT_EQ(kind(jump), static_cast<int>(Kind::kJump));
  Trajectory moving;
  moving.segments = {Quintic({{3, 8, 4}}, {{6, 8, 4}, {1, 0, 0}}, 4)};
  EXPECT_EQ(kind(moving), static_cast<int>(Kind::kNoRest));
  scene.teammates = {{2, Hover({9, 9, 4}, 0, 0)}};
  EXPECT_EQ(kind(leg({3, 8, 4}, {9, 8, 4}, 4)), static_cast<int>(Kind::kTeammate));
}

}  // namespace
}  // namespace citrine::planner

#include "logs/flight_measures.h"

#include <gtest/gtest.h>

namespace citrine::logs {
namespace {

using Phase = FlightStatus::Phase;

/// States at 50 Hz of a point that moves as `position` and `velocity` say.
template <class Position, class Velocity>
std::vector<UavState> Fly(double duration_s, Position position, Velocity velocity) {
  std::vector<UavState> states;
  for (int k = 0; k <= std::lround(duration_s * 50); ++k) {
    UavState state;
    state.utime = k * 20'000;
    state.X_WB.p = position(k * 0.02);
    state.v_W = velocity(k * 0.02);
    states.push_back(state);
  }
  return states;
}

std::vector<UavState> Circle(double radius_m, double rate_radps, double duration_s) {
  const auto at = [=](double t) { return rate_radps * t; };
  return Fly(
      duration_s,
      [=](double t) -> Eigen::Vector3d {
        return {radius_m * std::cos(at(t)), radius_m * std::sin(at(t)), 3};
      },
      [=](double t) -> Eigen::Vector3d {
        return {-radius_m * rate_radps * std::sin(at(t)), radius_m * rate_radps * std::cos(at(t)), 0};
      });
}

std::vector<UavState> Stand(const Eigen::Vector3d& p, double duration_s) {
  return Fly(
      duration_s, [=](double) { return p; },
      [](double) -> Eigen::Vector3d {
        return {0, 0, 0};
      });
}

TEST(FlightMeasures, PathLengthOfACircleIsItsCircumference) {
  // 500 chords: short of the arc by a part in 24 * (500 / 2 pi)^2 = 1.5e5.
  EXPECT_NEAR(PathLength(Circle(4, 2 * EIGEN_PI / 10, 10)), 8 * EIGEN_PI, 8 * EIGEN_PI * 1e-5);
  EXPECT_DOUBLE_EQ(PathLength({}), 0);
}

TEST(FlightMeasures, AccelerationOnACircleIsCentripetal) {
  const auto states = Circle(4, 1, 5);
  // The chord of 0.1 rad is short of its arc by 0.04 %.
  EXPECT_NEAR(*MaxOf(AccelerationOverTime(states)), 4, 4 * 0.0005);
  EXPECT_NEAR(*MinOf(AccelerationOverTime(states)), 4, 4 * 0.0005);
  EXPECT_NEAR(*MaxOf(SpeedOverTime(states)), 4, 1e-12);
  EXPECT_FALSE(MaxOf(AccelerationOverTime(Stand({0, 0, 0}, 0.05))).has_value());
}

TEST(FlightMeasures, SeparationIsThatOfTheNearestPairAtOneInstant) {
  std::vector<UavFlight> uavs(3);
  uavs[0].states = Stand({0, 0, 0}, 4);
  uavs[1].states = Fly(
      4,
      [](double t) -> Eigen::Vector3d {
        return {10 - 2 * t, 0, 0};
      },
      [](double) -> Eigen::Vector3d {
        return {-2, 0, 0};
      });
  uavs[2].states = Stand({0, 7, 0}, 4);
  const std::vector<Series> separations = SeparationOverTime(uavs);
  ASSERT_EQ(separations.size(), 3u);
  EXPECT_NEAR(separations[0].front().second, 7, 1e-12);
  EXPECT_NEAR(*MinOf(separations[0]), 2, 1e-12);
  EXPECT_NEAR(*MinOf(separations[1]), 2, 1e-12);
  EXPECT_NEAR(*MinOf(separations[2]), 7,
              1e-12);  // the first stands 7 m away, the second comes as near as 7.3 m
  EXPECT_NEAR(*MinOf(separations), 2, 1e-12);
  uavs.resize(1);
  EXPECT_FALSE(MinOf(SeparationOverTime(uavs)));
}

TEST(FlightMeasures, MeanSpeedCountsOnlyTheTimeBeforeAGoalIsReached) {
  UavFlight uav;
  uav.states = Fly(
      10,
      [](double) -> Eigen::Vector3d {
        return {0, 0, 0};
      },
      [](double t) -> Eigen::Vector3d {
        return {t < 5 ? 3.0 : 0.0, 0, 0};
      });
  EXPECT_FALSE(MeanSpeedUnderWay({uav}).has_value());
  const auto say = [&](double t, Phase phase) {
    FlightStatus status;
    status.phase = phase;
    uav.flight_statuses.push_back({FromSeconds(t), status});
  };
  say(0, Phase::kTracking);
  say(5, Phase::kReached);
  EXPECT_NEAR(*MeanSpeedUnderWay({uav}), 3, 1e-12);
  say(7.5, Phase::kBlocked);  // 250 states at 3 m/s and 126 at rest
  EXPECT_NEAR(*MeanSpeedUnderWay({uav}), 3.0 * 250 / 376, 1e-12);
}

TEST(FlightMeasures, ClearanceIsThatOfEveryState) {
  const Clearance height = [](const Eigen::Vector3d& p) { return p.z(); };
  const std::vector<UavState> circle = Circle(4, 1, 5);
  const Series series = ClearanceOverTime(circle, height);
  ASSERT_EQ(series.size(), circle.size());
  EXPECT_NEAR(series[7].second, circle[7].X_WB.p.z(), 1e-12);
  EXPECT_NEAR(*MinOf({series, ClearanceOverTime(Stand({0, 0, 5}, 1), height)}), 3, 1e-12);
  EXPECT_FALSE(MinOf(ClearanceOverTime({}, height)));
}

TEST(FlightMeasures, CountsAreThoseOfTheLastMessageOfEachUav) {
  std::vector<UavFlight> uavs(2);
  for (int i = 0; i < 2; ++i) {
    uavs[i].states = Stand({0, 0, 0}, 1);
    uavs[i].states.back().contacts = 2 + i;
    FleetStatus status;
    status.decisions = 10;
    status.elements_given_up = 9;
    uavs[i].statuses.push_back({0, status});
    status.decisions = 20 + i;
    status.elements_given_up = 3 + i;
    status.elements_unreachable = 7 - i;
    uavs[i].statuses.push_back({1'000'000, status});
  }
  EXPECT_EQ(Collisions(uavs), 5);
  EXPECT_EQ(Decisions(uavs), 41);
  EXPECT_EQ(ElementsGivenUp(uavs), 4);
  EXPECT_EQ(ElementsUnreachable(uavs), 7);
}

}  // namespace
}  // namespace citrine::logs

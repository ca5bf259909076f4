#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/dynamics/fleet_simulator.h"
#include "tests/sim/dynamics/dash.h"

namespace citrine::sim {
namespace {

constexpr double kStep_s = 0.02;

struct Tracking {
  double error_max_m = 0;
  double speed_max_mps = 0;
  double thrust_min_N = 1e9, thrust_max_N = 0;
  UavState last;
};

/// Flies one UAV for `seconds` and compares it with the trajectory.
Tracking Fly(const Trajectory& trajectory, double seconds, const UavSection& uav = {}) {
  FleetSimulator fleet({}, {trajectory.At(0).p_W}, uav, {}, 1);
  fleet.Follow(1, trajectory);
  Tracking tracking;
  for (int k = 0; k * kStep_s < seconds; ++k) {
    fleet.Step(FromSeconds(k * kStep_s), kStep_s);
    const UavState& state = fleet.state(1);
    const Eigen::Vector4d thrusts = fleet.rotor_thrusts_N(1);
    tracking.error_max_m =
        std::max(tracking.error_max_m, (state.X_WB.p - trajectory.At(state.utime).p_W).norm());
    tracking.speed_max_mps = std::max(tracking.speed_max_mps, state.v_W.norm());
    tracking.thrust_min_N = std::min(tracking.thrust_min_N, thrusts.minCoeff());
    tracking.thrust_max_N = std::max(tracking.thrust_max_N, thrusts.maxCoeff());
    tracking.last = state;
  }
  return tracking;
}

TEST(Tracking, HoversWithinTwoCentimetres) {
  const Tracking tracking = Fly(Hover({1, 2, 3}, 0.7, 0), 20);
  EXPECT_LT(tracking.error_max_m, 0.02);
  EXPECT_NEAR(YawOf(tracking.last.X_WB.q), 0.7, 0.01);
}

class DashIn : public testing::TestWithParam<std::tuple<Eigen::Vector3d, double>> {};

TEST_P(DashIn, IsTrackedWithinTenCentimetresAtTheLimits) {
  const auto [way, length] = GetParam();
  const Eigen::Vector3d from(0, 0, 30);
  const Trajectory dash = Dash(from, from + length * way.normalized(), 4.5, 4.8, FromSeconds(1));
  const Tracking tracking = Fly(dash, 3 + dash.duration_s());
  RecordProperty("error_max_mm", static_cast<int>(tracking.error_max_m * 1e3));
  EXPECT_LT(tracking.error_max_m, 0.1);
  EXPECT_GE(tracking.thrust_min_N, 0);
  EXPECT_LE(tracking.thrust_max_N, QuadrotorModel{}.rotor_thrust_max_N() * (1 + 1e-12));
  EXPECT_LT(tracking.last.v_W.norm(), 0.02);
}

// 7 m reaches both limits of a rest-to-rest quintic at once; 25 m cruises at the speed limit; 2 m is all
// acceleration.
INSTANTIATE_TEST_SUITE_P(Ways, DashIn,
                         testing::Combine(testing::Values(Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, -1, 0),
                                                          Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0, 0, -1),
                                                          Eigen::Vector3d(1, 1, 1),
                                                          Eigen::Vector3d(-1, 2, -1)),
                                          testing::Values(2.0, 7.0, 25.0)));

/// Speeds up and slows down again along x with a jerk that is constant and steps: the ramps of hard braking.
Trajectory Shuttle(double acceleration_mps2, double jerk_mps3) {
  const double ramp_s = acceleration_mps2 / jerk_mps3, hold_s = 0.4;
  Trajectory shuttle;
  shuttle.start = FromSeconds(1);
  double x = 0, v = 0, a = 0;
  for (const auto& [jerk, T] :
       {std::pair(jerk_mps3, ramp_s), std::pair(0.0, hold_s), std::pair(-jerk_mps3, 2 * ramp_s),
        std::pair(0.0, hold_s), std::pair(jerk_mps3, ramp_s)}) {
    TrajectorySegment segment;
    segment.duration_s = T;
    segment.coefficients.row(0) << x, v, a / 2, jerk / 6, 0, 0;
    segment.coefficients(2, 0) = 30;
    shuttle.segments.push_back(segment);
    x += T * (v + T * (a / 2 + T * jerk / 6));
    v += T * (a + T * jerk / 2);
    a += T * jerk;
  }
  return shuttle;
}

TEST(Tracking, FliesNoHarderThanIsAskedWhereTheJerkSteps) {
  constexpr double kAsked_mps2 = 4.5;
  const Trajectory shuttle = Shuttle(kAsked_mps2, 25);
  FleetSimulator fleet({}, {shuttle.At(0).p_W}, {}, {}, 1);
  fleet.Follow(1, shuttle);
  std::vector<Eigen::Vector3d> velocities_W;
  double hardest_mps2 = 0;
  for (int k = 0; k * kStep_s < 4; ++k) {
    fleet.Step(FromSeconds(k * kStep_s), kStep_s);
    velocities_W.push_back(fleet.state(1).v_W);
    if (k < 5) continue;
    const Eigen::Vector3d change = velocities_W.back() - *(velocities_W.end() - 6);
    hardest_mps2 = std::max(hardest_mps2, change.norm() / (5 * kStep_s));
  }
  EXPECT_LE(hardest_mps2, 1.01 * kAsked_mps2);
  EXPECT_GE(hardest_mps2, 0.97 * kAsked_mps2);
}

TEST(Tracking, ReachesTheSpeedThatIsAsked) {
  const Trajectory dash = Dash({0, 0, 10}, {25, 0, 10}, 4.5, 4.8, 0);
  EXPECT_NEAR(Fly(dash, 12).speed_max_mps, 4.5, 0.05);
}

TEST(Tracking, TurnsAsAsked) {
  Trajectory turn = Hover({0, 0, 5}, 0, 0);
  turn.segments[0].duration_s = 4;  // half a turn: peak 0.94 rad/s x 1.57
  turn.segments[0].coefficients.row(3) << 0, 0, 0, 10 * EIGEN_PI / 64, -15 * EIGEN_PI / 256,
      6 * EIGEN_PI / 1024;
  const Tracking tracking = Fly(turn, 6);
  EXPECT_LT(tracking.error_max_m, 0.02);
  EXPECT_NEAR(std::abs(WrapAngle(YawOf(tracking.last.X_WB.q) - EIGEN_PI)), 0, 0.01);
}

TEST(Tracking, HoldsItsPlaceInGusts) {
  UavSection windy;
  windy.wind_gust_mps = 4;
  const Tracking calm = Fly(Hover({0, 0, 5}, 0, 0), 30);
  const Tracking gusty = Fly(Hover({0, 0, 5}, 0, 0), 30, windy);
  EXPECT_GT(gusty.error_max_m, calm.error_max_m);
  EXPECT_LT(gusty.error_max_m,
            0.25);  // 4 m/s of air exert 1.9 m/s^2: 12 cm against a spring of (4 rad/s)^2, twice
}

TEST(Tracking, ReturnsFromFarOffItsReference) {
  FleetSimulator fleet({}, {{0, 0, 30}}, {}, {}, 1);
  fleet.Follow(1, Hover({20, -10, 25}, 1, FromSeconds(0.5)));
  for (int k = 0; k < 1500; ++k) {
    fleet.Step(FromSeconds(k * kStep_s), kStep_s);
    ASSERT_LT(std::acos((fleet.state(1).X_WB.q * Eigen::Vector3d::UnitZ()).z()), 1.3)
        << "fell over at step " << k;
  }
  EXPECT_LT((fleet.state(1).X_WB.p - Eigen::Vector3d(20, -10, 25)).norm(), 0.02);
}

}  // namespace
}  // namespace citrine::sim

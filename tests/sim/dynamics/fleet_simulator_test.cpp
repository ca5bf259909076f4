#include "sim/dynamics/fleet_simulator.h"

#include <cstring>

#include <gtest/gtest.h>

#include "core/vehicle/airframe.h"
#include "tests/sim/dynamics/dash.h"
#include "tests/sim/dynamics/meshes.h"

namespace citrine::sim {
namespace {

constexpr double kStep_s = 0.02;

void FlyFor(FleetSimulator& fleet, double seconds) {
  for (int k = 0; k * kStep_s < seconds; ++k) fleet.Step(FromSeconds(k * kStep_s), kStep_s);
}

TEST(FleetSimulator, CountsAWallInTheWayAsExactlyOneCollision) {
  FleetSimulator fleet(Wall(4), {{0, 0, 5}}, {}, {}, 1);
  fleet.Follow(1, Dash({0, 0, 5}, {10, 0, 5}, 4.5, 4.8, 0));
  FlyFor(fleet, 10);
  EXPECT_EQ(fleet.state(1).contacts, 1);
  EXPECT_LT(fleet.state(1).X_WB.p.x(), 4 - kAirframeRadius_m + 0.02);
  EXPECT_TRUE(fleet.state(1).X_WB.p.allFinite());
}

TEST(FleetSimulator, CountsNothingWhereTheWayIsFree) {
  FleetSimulator fleet(Wall(4), {{0, 0, 5}}, {}, {}, 1);
  fleet.Follow(1, Dash({0, 0, 5}, {4 - kAirframeRadius_m - 0.1, 0, 5}, 4.5, 4.8, 0));
  FlyFor(fleet, 10);
  EXPECT_EQ(fleet.state(1).contacts, 0);
}

TEST(FleetSimulator, CountsTwoUavsThatFlyHeadOnForBoth) {
  FleetSimulator fleet({}, {{0, 0, 5}, {10, 0, 5}, {5, 20, 5}}, {}, {}, 1);
  fleet.Follow(1, Dash({0, 0, 5}, {6, 0, 5}, 4.5, 4.8, 0));
  fleet.Follow(2, Dash({10, 0, 5}, {4, 0.05, 5}, 4.5, 4.8, 0));
  FlyFor(fleet, 1.8);
  EXPECT_EQ(fleet.state(1).contacts, 1);
  EXPECT_EQ(fleet.state(2).contacts, 1);
  EXPECT_EQ(fleet.state(3).contacts, 0);
}

TEST(FleetSimulator, StampsStatesWithTheEndOfTheStep) {
  FleetSimulator fleet({}, {{0, 0, 5}}, {}, {}, 1);
  EXPECT_EQ(fleet.state(1).utime, 0);
  fleet.Step(0, kStep_s);
  EXPECT_EQ(fleet.state(1).utime, 20000);
}

/// Poses and velocities of a windy flight into a wall beside another UAV, bit by bit.
std::vector<double> Flight(std::uint64_t seed) {
  UavSection windy;
  windy.wind_gust_mps = 5;
  FleetSimulator fleet(Wall(4), {{0, 0, 5}, {0, 3, 5}}, windy, {}, seed);
  fleet.Follow(1, Dash({0, 0, 5}, {6, 0, 5}, 4.5, 4.8, 0));
  std::vector<double> numbers;
  for (int k = 0; k < 400; ++k) {
    fleet.Step(FromSeconds(k * kStep_s), kStep_s);
    for (int uav = 1; uav <= 2; ++uav) {
      const UavState& state = fleet.state(uav);
      for (int axis = 0; axis < 3; ++axis) {
        numbers.insert(numbers.end(), {state.X_WB.p(axis), state.v_W(axis), state.omega_B(axis)});
      }
    }
  }
  return numbers;
}

TEST(FleetSimulator, GivesTheSameBitsForTheSameSeed) {
  const std::vector<double> first = Flight(7), second = Flight(7), other = Flight(8);
  ASSERT_EQ(first.size(), second.size());
  EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size() * sizeof(double)), 0);
  EXPECT_NE(first, other);
}

TEST(FleetSimulator, RefusesStepsTooCoarseForItsController) {
  DynamicsSection coarse;
  coarse.step_s = 0.02;
  coarse.substeps = 2;
  EXPECT_THROW(FleetSimulator({}, {{0, 0, 5}}, {}, coarse, 1), ConfigError);
  coarse.substeps = 4;
  EXPECT_NO_THROW(FleetSimulator({}, {{0, 0, 5}}, {}, coarse, 1));
}

TEST(FleetSimulator, HoversJustAsWellAtTheCoarsestStepThatItAllows) {
  DynamicsSection coarse;
  coarse.substeps = 4;
  FleetSimulator fleet({}, {{0, 0, 5}}, {}, coarse, 1);
  fleet.Follow(1, Dash({0, 0, 5}, {7, 0, 5}, 4.5, 4.8, 0));
  FlyFor(fleet, 6);
  EXPECT_LT((fleet.state(1).X_WB.p - Eigen::Vector3d(7, 0, 5)).norm(), 0.02);
}

}  // namespace
}  // namespace citrine::sim

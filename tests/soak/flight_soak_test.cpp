#include <gtest/gtest.h>

#include <cstdio>

#include "tests/soak/soak_flight.h"

// A sample of what flight_soak flies by the thousand.

namespace citrine::soak {
namespace {

constexpr double kVoxel_m = 0.25;
constexpr double kForest_s = 60, kEncounter_s = 90;

void ExpectFlownWithinLimits(const SoakResult& result) {
  const VehicleLimits limits;
  EXPECT_LE(result.flown_speed_mps, 1.01 * limits.speed_max_mps);
  EXPECT_LE(result.flown_acceleration_mps2, 1.01 * limits.acceleration_max_mps2);
}

void ExpectSafe(const SoakResult& result) {
  const VehicleLimits limits;
  EXPECT_EQ(result.contacts, 0);
  EXPECT_GE(result.clearance_m, limits.radius_m - kVoxel_m);
  EXPECT_GE(result.separation_m, 2 * limits.radius_m);  // of one alone it is endless
  EXPECT_LE(result.planned_speed_mps, 1.01 * limits.speed_max_mps);
  EXPECT_LE(result.planned_acceleration_mps2, 1.01 * limits.acceleration_max_mps2);
  EXPECT_LT(result.jump, 1e-6);
  EXPECT_EQ(result.arrived, result.uavs);
}

TEST(FlightSoak, ForestsAreFlownThroughAsTheyAreDiscovered) {
  for (const std::uint64_t seed : {1, 2, 3, 32, 284, 590}) {
    SCOPED_TRACE(seed);
    const SoakResult result = SoakFlight(Forest(seed), {}).Fly(kForest_s);
    ExpectSafe(result);
    ExpectFlownWithinLimits(result);
    EXPECT_LT(result.error_m, 0.1);
  }
}

TEST(FlightSoak, UavsThatMeetStayTwoRadiiApartAndArrive) {
  for (const int uavs : {2, 3})
    for (const Scenario& scenario : {HeadOn(4, uavs), Crossing(5, uavs), NarrowGap(5, uavs)}) {
      SCOPED_TRACE(scenario.kind + " of " + std::to_string(uavs));
      const SoakResult result = SoakFlight(scenario, {}).Fly(kEncounter_s);
      ExpectSafe(result);
      ExpectFlownWithinLimits(result);
    }
}

TEST(FlightSoak, GustsOfThreeMetresASecondAndNoisyLocalisationCauseNoCollision) {
  UavSection windy;
  windy.wind_gust_mps = 3;
  UavSection noisy;
  noisy.localisation_noise_m = 0.05;
  for (const UavSection& uav : {windy, noisy}) {
    ExpectSafe(SoakFlight(Forest(4), uav).Fly(kForest_s));
    ExpectSafe(SoakFlight(NarrowGap(1, 2), uav).Fly(kEncounter_s));
  }
}

TEST(FlightSoak, TheSameSeedFliesTheSame) {
  const SoakResult a = SoakFlight(Crossing(1, 2), {}).Fly(5), b = SoakFlight(Crossing(1, 2), {}).Fly(5);
  EXPECT_EQ(a.separation_m, b.separation_m);
  EXPECT_EQ(a.flown_acceleration_mps2, b.flown_acceleration_mps2);
  EXPECT_EQ(a.error_m, b.error_m);
}

}  // namespace
}  // namespace citrine::soak

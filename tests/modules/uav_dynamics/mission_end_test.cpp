#include "modules/uav_dynamics/mission_end.h"

#include <gtest/gtest.h>

namespace citrine {
namespace {

FleetStatus Says(bool no_view_left, std::int64_t map_version) {
  FleetStatus status;
  status.no_view_left = no_view_left;
  status.map_version = map_version;
  return status;
}

/// Asks every 20 ms over [from_s, to_s). @return the first reason and the time it was given
std::pair<std::optional<std::string>, double> Wait(MissionEnd& end, double from_s, double to_s) {
  for (double t = from_s; t < to_s; t += 0.02) {
    if (const auto reason = end.At(FromSeconds(t))) return {reason, t};
  }
  return {std::nullopt, to_s};
}

TEST(MissionEnd, ComesTwoSecondsAfterTheLastPlannerSawNoViewLeft) {
  MissionEnd end(2, 900);
  end.Hear(1, Says(true, 7));
  EXPECT_FALSE(Wait(end, 0, 10).first);
  end.Hear(2, Says(true, 7));
  const auto [reason, at_s] = Wait(end, 10, 20);
  EXPECT_EQ(reason, "surface_complete");
  EXPECT_NEAR(at_s, 12, 0.021);
}

TEST(MissionEnd, DoesNotComeWhileAPlannerHasNeverSpoken) {
  MissionEnd end(3, 900);
  end.Hear(1, Says(true, 7));
  end.Hear(3, Says(true, 7));
  EXPECT_FALSE(Wait(end, 0, 100).first);
}

TEST(MissionEnd, StartsAnewWhenAPlannerFindsAView) {
  MissionEnd end(2, 900);
  end.Hear(1, Says(true, 7));
  end.Hear(2, Says(true, 7));
  EXPECT_FALSE(Wait(end, 0, 1.9).first);
  end.Hear(1, Says(false, 8));
  end.Hear(1, Says(true, 8));
  end.Hear(2, Says(true, 8));
  EXPECT_FALSE(Wait(end, 1.9, 3.8).first);
  EXPECT_EQ(Wait(end, 3.8, 5).first, "surface_complete");
}

TEST(MissionEnd, WaitsUntilThoseWhoSpokeOfAnOlderMapHaveLookedAtTheNewer) {
  MissionEnd end(2, 900);
  end.Hear(1, Says(true, 10));
  end.Hear(2, Says(true, 12));
  EXPECT_FALSE(Wait(end, 0, 10).first);
  end.Hear(1, Says(true, 12));
  EXPECT_EQ(Wait(end, 10, 11).first, "surface_complete");
}

TEST(MissionEnd, WaitsForAVerdictOnTheMapThatTheBaseStationHeldWhenAllAgreed) {
  MissionEnd end(1, 900);
  end.HearMap(19, 0xa);
  end.HearMap(20, 0xb);
  end.Hear(1, Says(true, 19));
  EXPECT_FALSE(Wait(end, 0, 5).first);
  end.Hear(1, Says(true, 20));
  EXPECT_EQ(Wait(end, 5, 6).first, "surface_complete");
}

TEST(MissionEnd, IsNotPutOffByAMapThatGoesOnChanging) {
  MissionEnd end(2, 900);
  std::optional<std::string> reason;
  double t = 0;
  for (std::int64_t version = 20; !reason && t < 10; t += 0.5, ++version) {
    end.HearMap(version, static_cast<std::uint64_t>(version));
    end.Hear(1, Says(true, version - 1));
    end.Hear(2, Says(true, version - 2));
    reason = end.At(FromSeconds(t));
  }
  EXPECT_EQ(reason, "surface_complete");
  EXPECT_LE(t, 3.0);
}

TEST(MissionEnd, DoesNotAskForANewVerdictOnVersionsThatAreTheSameMap) {
  MissionEnd end(2, 900);
  end.HearMap(20, 0xa);
  end.Hear(1, Says(true, 20));
  for (std::int64_t version = 21; version < 40; ++version) end.HearMap(version, 0xa);
  end.Hear(2, Says(true, 30));
  EXPECT_EQ(Wait(end, 0, 5).first, "surface_complete");
}

TEST(MissionEnd, ComesAtTheTimeLimit) {
  MissionEnd end(1, 30);
  const auto [reason, at_s] = Wait(end, 0, 60);
  EXPECT_EQ(reason, "time_limit");
  EXPECT_NEAR(at_s, 30, 0.021);
}

TEST(MissionEnd, IgnoresUavsThatAreNotOfTheFleet) {
  MissionEnd end(1, 900);
  end.Hear(0, Says(true, 1));
  end.Hear(2, Says(true, 1));
  EXPECT_FALSE(Wait(end, 0, 5).first);
}

}  // namespace
}  // namespace citrine

#include "modules/reflection/traffic.h"

#include <gtest/gtest.h>

#include "modules/channels.h"

namespace citrine {
namespace {

std::vector<std::uint8_t> Clock(std::int64_t seq) {
  citrine_lcm::clock_t clock{};
  clock.utime = 20'000 * seq;
  clock.seq = seq;
  return Bus::ToBytes(clock);
}

TEST(Traffic, CountsMessagesBytesAndGaps) {
  Traffic traffic;
  EXPECT_EQ(traffic.Hear("CLOCK", Clock(1), 0).lost, 0);
  EXPECT_EQ(traffic.Hear("CLOCK", Clock(5), 1).lost, 3);
  EXPECT_EQ(traffic.Hear("CLOCK", Clock(5), 2).lost, 0) << "a repetition";
  const ChannelTraffic& clock = traffic.channels().at("CLOCK");
  EXPECT_EQ(clock.type, "clock_t");
  EXPECT_EQ(clock.messages, 3);
  EXPECT_EQ(clock.lost, 3);
  EXPECT_EQ(clock.bytes, static_cast<std::int64_t>(3 * Clock(1).size()));
  EXPECT_EQ(clock.first, 20'000);
  EXPECT_EQ(clock.last, 100'000);
}

TEST(Traffic, TellsSendersOfOneChannelApart) {
  Traffic traffic;
  for (const int uav : {1, 2}) {
    citrine_lcm::module_health_t health{};
    health.seq = uav == 1 ? 7 : 1;
    health.module = "view_planner";
    health.uav = uav;
    EXPECT_EQ(traffic.Hear("MODULE_HEALTH", Bus::ToBytes(health), 0).lost, 0);
  }
}

TEST(Traffic, HasTheRateOfTheLastSeconds) {
  Traffic traffic(2);
  for (int i = 0; i <= 100; ++i) traffic.Hear("CLOCK", Clock(i + 1), 0.1 * i);
  const ChannelTraffic& clock = traffic.channels().at("CLOCK");
  EXPECT_NEAR(traffic.RateAt(10, clock).messages_hz, 10, 0.51);  // one more or less in two seconds
  EXPECT_NEAR(traffic.RateAt(11, clock).messages_hz, 5, 0.51);
  EXPECT_EQ(traffic.RateAt(13, clock).messages_hz, 0);
}

TEST(Traffic, CountsWhatIsNotOurs) {
  Traffic traffic;
  EXPECT_EQ(traffic.Hear("X", std::vector<std::uint8_t>{1, 2}, 0).bad, "no type of ours");
  auto cut = Clock(1);
  cut.pop_back();
  EXPECT_EQ(traffic.Hear("CLOCK", cut, 0).bad, "cut short");
  EXPECT_EQ(traffic.channels().at("X").type, "?");
  EXPECT_EQ(traffic.channels().at("CLOCK").bad, 1);
}

}  // namespace
}  // namespace citrine

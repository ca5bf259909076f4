#include "modules/runtime/bus.h"

#include <gtest/gtest.h>

#include "modules/channels.h"

namespace citrine {
namespace {

constexpr Utime kDt = 20'000;

Step At(std::int64_t index) { return {index, index * kDt, false}; }

citrine_lcm::mission_progress_t Progress(int surface_voxels) {
  citrine_lcm::mission_progress_t message{};
  message.surface_voxels = surface_voxels;
  return message;
}

TEST(Bus, StampsMissionTimeAndCountsPerChannel) {
  Bus bus("memq://");
  const auto inbox = bus.HearAll(channels::kUavState);
  bus.BeginStep(At(3), false);
  bus.Publish(channels::kUavState, 2, {});
  bus.Publish(channels::kUavState, 2, {});
  bus.Publish(channels::kUavState, 12, {});
  bus.Handle(100);
  bus.BeginStep(At(4), false);
  const auto entries = inbox->Take();
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(entries[0].uav, 12) << "in order of channel";
  EXPECT_EQ(entries[0].message.seq, 1);
  EXPECT_EQ(entries[1].uav, 2);
  EXPECT_EQ(entries[2].message.seq, 2);
  EXPECT_EQ(entries[2].message.utime, 3 * kDt);
  EXPECT_TRUE(inbox->Take().empty()) << "each entry once";
  EXPECT_EQ(bus.last_said().at("UAV2_STATE"), 2);
}

TEST(Bus, ShowsInLockstepWhatWasSaidBeforeAndNothingElse) {
  const auto transport = std::make_shared<Transport>("memq://");
  Bus ahead(transport), behind(transport);
  const auto inbox = behind.Hear(channels::kMissionProgress);
  ahead.BeginStep(At(1), true);
  ahead.Publish(channels::kMissionProgress, Progress(1));
  ahead.BeginStep(At(2), true);
  ahead.Publish(channels::kMissionProgress, Progress(2));
  behind.Handle(100);  // it has arrived before `behind` begins the steps in which it was said
  behind.BeginStep(At(1), true);
  EXPECT_TRUE(inbox->Take().empty());
  behind.BeginStep(At(2), true);
  auto entries = inbox->Take();
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].message.surface_voxels, 1);
  behind.BeginStep(At(3), true);
  entries = inbox->Take();
  ASSERT_EQ(entries.size(), 1u);
  EXPECT_EQ(entries[0].message.surface_voxels, 2);
}

TEST(Bus, LetsEveryInboxOfAChannelHaveEveryMessage) {
  Bus bus("memq://");
  const auto one = bus.Hear(channels::kMissionProgress), other = bus.Hear(channels::kMissionProgress);
  for (int i = 0; i < 100; ++i) bus.Publish(channels::kMissionProgress, Progress(i));
  bus.Handle(100);
  bus.BeginStep(At(1), true);
  EXPECT_EQ(one->Take().size(), 100u) << "LCM's default queue would have dropped 70";
  EXPECT_EQ(other->Take().size(), 100u);
  EXPECT_EQ(bus.counts().lost, 0);
}

TEST(Bus, DropsAndCountsWhatDoesNotDecode) {
  Bus bus("memq://");
  const auto inbox = bus.Hear(channels::kMissionProgress);
  bus.SayBytes("MISSION_PROGRESS", {1, 2, 3});
  auto cut = Bus::ToBytes(Progress(1));
  cut.pop_back();
  bus.SayBytes("MISSION_PROGRESS", cut);
  bus.Publish(channels::kMissionProgress, Progress(7));
  bus.Handle(100);
  bus.BeginStep(At(1), true);
  EXPECT_EQ(bus.counts().bad, 2);
  EXPECT_NE(bus.counts().last_bad.find("MISSION_PROGRESS"), std::string::npos);
  ASSERT_EQ(inbox->Take().size(), 1u);
}

TEST(Bus, LivesThroughANegativeCountInAMessage) {
  Bus bus("memq://");
  const auto inbox = bus.Hear(channels::kPath, 1);
  auto bytes = Bus::ToBytes(citrine_lcm::path_t{});
  for (std::size_t i = bytes.size() - 4; i < bytes.size(); ++i)
    bytes[i] = 0xff;  // num_waypoints, the last field
  bus.SayBytes("UAV1_PATH", bytes);
  bus.Handle(100);
  EXPECT_EQ(bus.counts().bad, 1);
}

TEST(Bus, CountsGapsOncePerMessageAndSender) {
  const auto transport = std::make_shared<Transport>("memq://");
  Bus hearer(transport), one(transport), two(transport);
  const auto inbox = hearer.Hear(channels::kFleetAssignment), again = hearer.Hear(channels::kFleetAssignment);
  const auto say = [](Bus& bus, int sender) {
    citrine_lcm::fleet_assignment_t message{};
    message.sender = sender;
    bus.Publish(channels::kFleetAssignment, message);
  };
  for (int i = 0; i < 3; ++i) say(one, 1);
  say(two, 2);
  hearer.Handle(100);
  EXPECT_EQ(hearer.counts().lost, 0) << "two senders count each for itself";
  citrine_lcm::fleet_assignment_t late{};
  late.sender = 1;
  late.seq = 6;
  one.SayBytes("FLEET_ASSIGNMENT", Bus::ToBytes(late));
  hearer.Handle(100);
  EXPECT_EQ(hearer.counts().lost, 2);
  hearer.BeginStep(At(1), true);
  EXPECT_EQ(inbox->Take().size(), 5u);
  EXPECT_EQ(again->Take().size(), 5u);
}

TEST(Bus, KnowsWhatItMissesOfWhatItHears) {
  const auto transport = std::make_shared<Transport>("memq://");
  Bus hearer(transport), sayer(transport);
  const auto states = hearer.Hear(channels::kUavState, 1);
  EXPECT_FALSE(hearer.Misses("UAV2_STATE", 0, 1)) << "it does not listen to that one";
  EXPECT_TRUE(hearer.Misses("UAV1_STATE", 0, 1));
  sayer.Publish(channels::kUavState, 1, {});
  hearer.Handle(100);
  EXPECT_FALSE(hearer.Misses("UAV1_STATE", 0, 1));
  EXPECT_TRUE(hearer.Misses("UAV1_STATE", 0, 3));
  hearer.GiveUp("UAV1_STATE", 0, 3);
  EXPECT_EQ(hearer.counts().lost, 2);
  EXPECT_FALSE(hearer.Misses("UAV1_STATE", 0, 3));
}

TEST(Bus, RethrowsAHearersErrorAndGoesOn) {
  Bus bus("memq://");
  int heard = 0;
  bus.HearBytes("MISSION_PROGRESS", [&](const std::string&, const void*, int) {
    if (++heard == 1) throw std::runtime_error("once");
  });
  bus.Publish(channels::kMissionProgress, Progress(1));
  bus.Publish(channels::kMissionProgress, Progress(2));
  EXPECT_THROW(bus.Handle(100), std::runtime_error);
  EXPECT_EQ(bus.Handle(100), 1);
  EXPECT_EQ(heard, 2);
}

TEST(Bus, RefusesAMessageThatWouldNotTravel) {
  Bus bus("memq://");
  EXPECT_NO_THROW(bus.SayBytes("MAP_BLOCKS", std::vector<std::uint8_t>(Bus::kMaxMessageBytes)));
  EXPECT_THROW(bus.SayBytes("MAP_BLOCKS", std::vector<std::uint8_t>(Bus::kMaxMessageBytes + 1)),
               std::length_error);
}

TEST(Bus, SaysWhatIsWrongWithAUrl) { EXPECT_THROW(Bus("nonsense://x"), std::runtime_error); }

TEST(Transport, HearsItselfInMemory) { EXPECT_NO_THROW(Transport("memq://").CheckHearsItself()); }

TEST(Transport, ForgetsABusThatIsGone) {
  const auto transport = std::make_shared<Transport>("memq://");
  Bus sayer(transport);
  {
    const Bus gone(transport);
    std::make_unique<Bus>(transport)->Hear(channels::kMissionProgress);
  }
  sayer.Publish(channels::kMissionProgress, Progress(1));
  EXPECT_NO_THROW(sayer.Handle(10));
}

}  // namespace
}  // namespace citrine

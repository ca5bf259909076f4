#include "modules/reflection/message_fields.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "modules/channels.h"
#include "modules/codec/bad_message.h"
#include "modules/reflection/message_types.h"

namespace citrine {
namespace {

template <class Value>
std::vector<Value> Values(const std::vector<FieldValues>& fields, const std::string& name) {
  for (const FieldValues& field : fields)
    if (field.type->name == name) return std::get<std::vector<Value>>(field.values);
  throw std::out_of_range(name);
}

citrine_lcm::module_health_t Health() {
  citrine_lcm::module_health_t health{};
  health.utime = -5;
  health.seq = std::int64_t{1} << 40;
  health.worst_tick_ms = -0.125;
  health.uav = -3;
  health.state = 2;
  health.module = "view_planner";
  health.last_error = "";
  health.num_names = 2;
  health.sample_names = {"a", "b c"};
  health.num_samples = {1, 2};
  health.num_values = 3;
  health.sample_values = {1.5f, -2.5f, 1e-20f};
  return health;
}

std::vector<FieldValues> Read(const std::vector<std::uint8_t>& bytes) {
  return ReadFields(*TypeOf(bytes), bytes);
}

// The truth is what lcm-gen's own encoder wrote.
TEST(MessageFields, HoldWhatWasEncoded) {
  const auto health = Health();
  const auto fields = Read(Bus::ToBytes(health));
  EXPECT_EQ(Values<std::int64_t>(fields, "utime"), std::vector<std::int64_t>{health.utime});
  EXPECT_EQ(Values<std::int64_t>(fields, "seq"), std::vector<std::int64_t>{health.seq});
  EXPECT_EQ(Values<double>(fields, "worst_tick_ms"), std::vector<double>{health.worst_tick_ms});
  EXPECT_EQ(Values<std::int64_t>(fields, "uav"), std::vector<std::int64_t>{-3});
  EXPECT_EQ(Values<std::int64_t>(fields, "state"), std::vector<std::int64_t>{2});
  EXPECT_EQ(Values<std::string>(fields, "module"), std::vector<std::string>{"view_planner"});
  EXPECT_EQ(Values<std::string>(fields, "last_error"), std::vector<std::string>{""});
  EXPECT_EQ(Values<std::string>(fields, "sample_names"), health.sample_names);
  EXPECT_EQ(Values<std::int64_t>(fields, "num_samples"), (std::vector<std::int64_t>{1, 2}));
  EXPECT_EQ(Values<double>(fields, "sample_values"), (std::vector<double>{1.5, -2.5, 1e-20f}));
}

TEST(MessageFields, HoldFixedArraysBooleansAndBytes) {
  citrine_lcm::fleet_status_t status{};
  status.p_WB[2] = 4.25;
  status.has_goal = 1;
  const auto fields = Read(Bus::ToBytes(status));
  EXPECT_EQ(Values<double>(fields, "p_WB"), (std::vector<double>{0, 0, 4.25}));
  EXPECT_EQ(Values<std::int64_t>(fields, "has_goal"), std::vector<std::int64_t>{1});
  citrine_lcm::strategy_message_t message{};
  message.num_bytes = 3;
  message.data = {1, 255, 0};
  EXPECT_EQ(Values<std::uint8_t>(Read(Bus::ToBytes(message)), "data"), message.data);
}

TEST(MessageFields, TellWhoSpokeWhereSeveralDo) {
  EXPECT_EQ(SenderOf(Read(Bus::ToBytes(Health()))), "view_planner/-3");
  citrine_lcm::fleet_assignment_t assignment{};
  assignment.sender = 2;
  EXPECT_EQ(SenderOf(Read(Bus::ToBytes(assignment))), "2");
  EXPECT_EQ(SenderOf(Read(Bus::ToBytes(citrine_lcm::clock_t{}))), "");
}

TEST(MessageFields, RefuseWhatIsCutShortOrTooLong) {
  const auto bytes = Bus::ToBytes(Health());
  const MessageType& type = *TypeOf(bytes);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THROW(ReadFields(type, std::span(bytes).first(size)), BadMessage) << size;
  auto longer = bytes;
  longer.push_back(0);
  EXPECT_THROW(ReadFields(type, longer), BadMessage);
}

TEST(MessageFields, RefuseCountsThatCannotBe) {
  citrine_lcm::strategy_message_t message{};
  message.num_bytes = 3;
  message.data = {1, 2, 3};
  auto bytes = Bus::ToBytes(message);
  for (const std::uint8_t top : {0x7f, 0x80, 0xff}) {
    bytes[bytes.size() - 7] = top;  // num_bytes
    EXPECT_THROW(Read(bytes), BadMessage);
  }
}

TEST(MessageFields, LiveThroughAnyDamage) {
  const auto bytes = Bus::ToBytes(Health());
  Random random(7);
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    auto damaged = bytes;
    for (int k = 0; k < 3; ++k)
      damaged[8 + random.Next() % (bytes.size() - 8)] = static_cast<std::uint8_t>(random.Next());
    try {
      Read(damaged);
    } catch (const BadMessage&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 5000);
}

}  // namespace
}  // namespace citrine

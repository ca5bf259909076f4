#include "modules/reflection/message_text.h"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "modules/channels.h"
#include "modules/reflection/message_types.h"

namespace citrine {
namespace {

using ::testing::HasSubstr;

template <class Message>
std::string TextOf(const Message& message) {
  const auto bytes = Bus::ToBytes(message);
  return ToText(*TypeOf(bytes), ReadFields(*TypeOf(bytes), bytes));
}

template <class Message>
nlohmann::json JsonOf(const Message& message) {
  const auto bytes = Bus::ToBytes(message);
  return nlohmann::json::parse("{" + ToJsonMembers(ReadFields(*TypeOf(bytes), bytes)) + "}");
}

TEST(MessageText, NamesUnitsAndConstants) {
  citrine_lcm::clock_t clock{};
  clock.dt_s = 0.02;
  clock.state = citrine_lcm::clock_t::DONE;
  clock.mission_id = "smoke";
  const std::string text = TextOf(clock);
  EXPECT_THAT(text, HasSubstr("  dt_s [s]  0.02\n"));
  EXPECT_THAT(text, HasSubstr("  state  1  DONE\n"));
  EXPECT_THAT(text, HasSubstr("  mission_id  \"smoke\"\n"));
}

TEST(MessageText, CutsLongArraysCountsBytesAndKeepsTextsOfSeveralLines) {
  citrine_lcm::map_blocks_t blocks{};
  blocks.num_blocks = 20;
  blocks.index.resize(20, 3);
  blocks.version.resize(20, 1);
  blocks.num_bytes = 5;
  blocks.codes.resize(5);
  const std::string text = TextOf(blocks);
  EXPECT_THAT(text, HasSubstr("3  ... 20 values\n"));
  EXPECT_THAT(text, HasSubstr("  codes  5 bytes\n"));
  citrine_lcm::mission_config_t config{};
  config.toml = "[mission]\nuavs = 2\n";
  EXPECT_THAT(TextOf(config), HasSubstr("  toml\n    | [mission]\n    | uavs = 2\n"));
  EXPECT_THAT(TextOf(config), HasSubstr("  overrides  none\n"));
}

TEST(MessageText, IsJsonThatAnotherReaderReads) {
  citrine_lcm::strategy_message_t message{};
  message.utime = 20000;
  message.kind = "a \"quoted\"\ttext\\";
  message.num_bytes = 2;
  message.data = {0x0a, 0xff};
  const nlohmann::json json = JsonOf(message);
  EXPECT_EQ(json["utime"], 20000);
  EXPECT_EQ(json["kind"], message.kind);
  EXPECT_EQ(json["data"], "0aff");
  citrine_lcm::uav_state_t state{};
  state.v_W[1] = 0.1;
  state.v_W[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(JsonOf(state)["v_W"][1], 0.1);
  EXPECT_TRUE(JsonOf(state)["v_W"][2].is_null());
  EXPECT_EQ(JsonOf(citrine_lcm::path_t{})["x_W"], nlohmann::json::array());
}

}  // namespace
}  // namespace citrine

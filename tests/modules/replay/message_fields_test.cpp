#include "modules/replay/message_fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/map/map_block.h"
#include "modules/codec/map_blocks.h"
#include "tests/modules/replay/recorded_words.h"

namespace citrine {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> NamesOf(const LogEvent& event) {
  std::vector<std::string> names;
  for (const MessageField& field : FieldsOf(event)) names.push_back(field.name);
  return names;
}

TEST(MessageFields, AreThoseOfTheLcmFileInItsOrder) {
  EXPECT_THAT(
      NamesOf(test::RecordedState(20'000, 3, 1.5, 2)),
      ElementsAre("utime", "seq", "p_WB[0]", "p_WB[1]", "p_WB[2]", "q_WB[0]", "q_WB[1]", "q_WB[2]", "q_WB[3]",
                  "v_W[0]", "v_W[1]", "v_W[2]", "omega_B[0]", "omega_B[1]", "omega_B[2]", "num_contacts"));
  const auto fields = FieldsOf(test::RecordedState(20'000, 3, 1.5, 2));
  EXPECT_EQ(fields[0].ValueText(), "20000");
  EXPECT_EQ(fields[1].ValueText(), "3");
  EXPECT_EQ(fields[2].ValueText(), "1.5");
}

TEST(MessageFields, ShowTheVoxelsOfABlockAndNotItsPackedBytes) {
  MapBlock block;
  block.index = 5;
  block.version = 1;
  block.distance[17] = 200;
  const auto fields = FieldsOf(test::Recorded(channels::kMapBlocks.name, 0, 1, Encode(std::vector{block})));
  ASSERT_EQ(fields.size(), 5u + 2 * kBlockVoxels);
  EXPECT_EQ(fields[5 + 17].name, "distance code of block 5[17]");
  EXPECT_EQ(fields[5 + 17].ValueText(), "200");
}

TEST(MessageFields, AreNoneWhereNothingDecodes) {
  LogEvent event = test::RecordedState(0, 1, 1);
  event.bytes.resize(event.bytes.size() / 2);
  EXPECT_TRUE(FieldsOf(event).empty());
  EXPECT_TRUE(FieldsOf({0, "FOREIGN", {1, 2, 3}}).empty());
}

}  // namespace
}  // namespace citrine

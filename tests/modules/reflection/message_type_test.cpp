#include "modules/reflection/message_types.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "modules/channels.h"

namespace citrine {
namespace {

using Kind = FieldType::Kind;
using ::testing::HasSubstr;

constexpr const char* kExample = R"(package somewhere;

// What it says.
struct example_t
{
    int64_t utime;                  // [us] mission time
    double p_W[3];
    int32_t n;                      // of them; [m] is no unit here
    float grid[n][2];               // [1/m^2]
    string names[n];                // [-] plain

    const int8_t OFF = -1;
    const int16_t FAR = 300;
}
)";

TEST(MessageType, IsReadFromAnLcmFile) {
  const MessageType type = ParseMessageType(kExample);
  EXPECT_EQ(type.name, "example_t");
  const std::vector<FieldType> fields = {{"utime", Kind::kInt64, {}, "us"},
                                         {"p_W", Kind::kDouble, {"3"}, ""},
                                         {"n", Kind::kInt32, {}, ""},
                                         {"grid", Kind::kFloat, {"n", "2"}, "1/m^2"},
                                         {"names", Kind::kString, {"n"}, ""}};
  EXPECT_EQ(type.fields, fields);
  const std::vector<ConstantType> constants = {{"OFF", Kind::kInt8, -1}, {"FAR", Kind::kInt16, 300}};
  EXPECT_EQ(type.constants, constants);
}

TEST(MessageType, RefusesWhatItDoesNotKnowAndNamesIt) {
  const auto error_of = [](const char* text) -> std::string {
    try {
      ParseMessageType(text);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_THAT(error_of("struct a_t\n{\n other_t nested;\n}"), HasSubstr("other_t"));
  EXPECT_THAT(error_of("struct a_t\n{\n int8_t a, b;\n}"), HasSubstr("int8_t a, b;"));
  EXPECT_THAT(error_of("package p;"), HasSubstr("no struct"));
}

TEST(MessageTypes, AreAllThatTravelAndAreFoundByTheirFingerprint) {
  EXPECT_EQ(MessageTypes().size(), 17u);
  citrine_lcm::path_t path{};
  const auto bytes = Bus::ToBytes(path);
  ASSERT_TRUE(TypeOf(bytes));
  EXPECT_EQ(TypeOf(bytes)->name, "path_t");
  for (const MessageType& type : MessageTypes()) {
    EXPECT_EQ(type.fields.at(0).name, "utime") << type.name;
    EXPECT_EQ(type.fields.at(0).unit, "us") << type.name;
  }
}

TEST(MessageTypes, KnowNothingOfOtherBytes) {
  EXPECT_FALSE(TypeOf(std::vector<std::uint8_t>{1, 2, 3}));
  EXPECT_FALSE(TypeOf(std::vector<std::uint8_t>(100, 7)));
}

}  // namespace
}  // namespace citrine

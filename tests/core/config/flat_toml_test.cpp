#include "core/config/flat_toml.h"

#include <gtest/gtest.h>

#include "core/config/config_file.h"

namespace citrine {
namespace {

TEST(FlatToml, NamesEveryValueByItsWholePath) {
  const auto values = FlattenToml("[a]\nx = 1\ny = [1, 2]\n[a.b]\nz = \"t\"\n[[r]]\nk = 1\n[[r]]\nk = 2\n");
  const std::map<std::string, std::string> expected = {
      {"a.x", "1"}, {"a.y", "[ 1, 2 ]"}, {"a.b.z", "'t'"}, {"r[0].k", "1"}, {"r[1].k", "2"}};
  EXPECT_EQ(values, expected);
  EXPECT_THROW(FlattenToml("a ="), ConfigError);
}

TEST(FlatToml, TellsTwoMissionsApartByTheKeyThatDiffers) {
  MissionConfig config;
  const auto before = FlattenToml(ToToml(config));
  config.planner.alpha = 1.5;
  auto after = FlattenToml(ToToml(config));
  EXPECT_NE(before, after);
  after["planner.alpha"] = before.at("planner.alpha");
  EXPECT_EQ(before, after);
}

}  // namespace
}  // namespace citrine

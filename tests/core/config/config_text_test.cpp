#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/config/config_file.h"
#include "core/config/nearest_name.h"
#include "core/config/number_text.h"

namespace citrine {
namespace {

using ::testing::HasSubstr;

TEST(ConfigText, AConfigurationSurvivesBeingWrittenAndReadAgain) {
  MissionConfig config;
  config.mission.name = "a \"quoted\" \\ name\twith a tab";
  config.mission.volume_min_m = Eigen::Vector3d(-1.1, 0.1 + 0.2, 0);
  config.mission.volume_max_m = Eigen::Vector3d(1e-3, 4, 1e6 / 7);
  config.mission.spawns_m = {{-0.1, 1, 3}, {-0.5, 2.5, 4}};
  config.planner.alpha = 1.0 / 3.0;
  config.planner.balance = false;
  config.mission.seed = 1234567;
  config.quality_regions.push_back({Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 2, 3), 2.75});
  const std::string text = ToToml(config);
  const MissionConfig again = ParseMission(text, {});
  EXPECT_EQ(ToToml(again), text);
  EXPECT_EQ(again.mission.name, config.mission.name);
  EXPECT_EQ(*again.mission.volume_min_m, *config.mission.volume_min_m);
  EXPECT_EQ(*again.mission.volume_max_m, *config.mission.volume_max_m);
  EXPECT_EQ(again.mission.spawns_m, config.mission.spawns_m);
  EXPECT_EQ(again.planner.alpha, config.planner.alpha);
  EXPECT_EQ(again.quality_regions[0].d_star_m, 2.75);
}

TEST(ConfigText, EveryDefaultIsItselfAllowed) { EXPECT_NO_THROW(ParseMission(ToToml(MissionConfig()), {})); }

TEST(ConfigText, TheTableNamesKeyUnitDefaultRangeAndMeaning) {
  const std::string table = DescribeKeys();
  EXPECT_THAT(
      table,
      HasSubstr("map.voxel_m                    m      0.25               [0.02, 2]       edge of a voxel"));
  EXPECT_THAT(table, HasSubstr("best_view | per_scan | per_point"));
  EXPECT_THAT(table, HasSubstr("[[quality.region]].d_star_m"));
}

TEST(NumberText, IsTheShortestThatReadsBack) {
  EXPECT_EQ(NumberText(0.42), "0.42");
  EXPECT_EQ(NumberText(900), "900");
  EXPECT_EQ(std::stod(NumberText(0.1 + 0.2)), 0.1 + 0.2);
}

TEST(NearestName, CountsEdits) {
  EXPECT_EQ(NearestName("voxle_m", {"rows", "voxel_m", "truncation_m"}), "voxel_m");
  EXPECT_EQ(NearestName("x", {}), "");
}

}  // namespace
}  // namespace citrine

#include "core/config/config_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace citrine {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string RefusalOf(const std::string& toml, const std::vector<std::string>& overrides = {}) {
  try {
    ParseMission(toml, overrides);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "(accepted)";
}

TEST(ConfigFile, AnEmptyMissionHasTheDefaults) {
  const MissionConfig config = ParseMission("", {});
  EXPECT_EQ(config.mission.uavs, 3);
  EXPECT_EQ(config.map.voxel_m, 0.25);
  EXPECT_EQ(config.planner.strategy, "quality_adaptive");
  EXPECT_FALSE(config.mission.volume_min_m.has_value());
}

TEST(ConfigFile, ReadsEveryKindOfField) {
  const MissionConfig config = ParseMission(R"(
[mission]
name = "yard"
uavs = 2
time_limit_s = 60
volume_min_m = [-1, -2.5, 0]
volume_max_m = [1, 2.5, 10]
spawns_m = [[0, 0, 3], [0.5, 1, 4]]
[planner]
balance = false
[[quality.region]]
min_m = [0, 0, 0]
max_m = [1, 1, 1]
d_star_m = 2
)",
                                            {});
  EXPECT_EQ(config.mission.name, "yard");
  EXPECT_EQ(config.mission.uavs, 2);
  EXPECT_EQ(config.mission.time_limit_s, 60);
  EXPECT_EQ(*config.mission.volume_min_m, Eigen::Vector3d(-1, -2.5, 0));
  ASSERT_EQ(config.mission.spawns_m.size(), 2u);
  EXPECT_EQ(config.mission.spawns_m[1], Eigen::Vector3d(0.5, 1, 4));
  EXPECT_FALSE(config.planner.balance);
  ASSERT_EQ(config.quality_regions.size(), 1u);
  EXPECT_EQ(config.quality_regions[0].d_star_m, 2);
}

TEST(ConfigFile, RefusesAnUnknownKeyAndNamesTheNearestKnownOne) {
  EXPECT_EQ(RefusalOf("[mission]\nuav_count = 3"),
            "mission.uav_count: unknown key; did you mean mission.uavs?");
}

TEST(ConfigFile, NamesTheSectionToWhichAKeyBelongs) {
  EXPECT_EQ(RefusalOf("[mission]\nvoxel_m = 0.2"), "mission.voxel_m: unknown key; did you mean map.voxel_m?");
}

TEST(ConfigFile, RefusesAnUnknownSection) {
  EXPECT_EQ(RefusalOf("[planer]\nalpha = 1"), "planer: unknown section; did you mean planner?");
}

TEST(ConfigFile, RefusesAKeyOutsideOfAnySection) {
  EXPECT_THAT(RefusalOf("map = 3"), StartsWith("map: must be a section, [map]"));
}

TEST(ConfigFile, RefusesAWrongTypeAndSaysWhatIsAllowed) {
  EXPECT_EQ(RefusalOf("[mission]\nuavs = 'three'"),
            "mission.uavs: must be an integer in [1, 15], is 'three'");
  EXPECT_EQ(RefusalOf("[mission]\nuavs = 2.5"), "mission.uavs: must be an integer in [1, 15], is 2.5");
  EXPECT_THAT(RefusalOf("[planner]\nbalance = 1"),
              StartsWith("planner.balance: must be true or false, is 1"));
  EXPECT_THAT(RefusalOf("[mission]\nvolume_min_m = [0, 1]"),
              StartsWith("mission.volume_min_m: must be three numbers [x, y, z], is [ 0, 1 ]"));
  EXPECT_THAT(RefusalOf("[mission]\nspawns_m = [[0, 0, 3], 4]"),
              StartsWith("mission.spawns_m: must be a list"));
}

TEST(ConfigFile, RefusesAValueOutOfRange) {
  EXPECT_EQ(RefusalOf("[mission]\nuavs = 0"), "mission.uavs: must be an integer in [1, 15], is 0");
  EXPECT_EQ(RefusalOf("[map]\nvoxel_m = 0"), "map.voxel_m: must be a number in [0.02, 2], is 0");
  EXPECT_THAT(RefusalOf("[map]\nvoxel_m = nan"), StartsWith("map.voxel_m: must be a number"));
  EXPECT_THAT(RefusalOf("[mission]\nseed = 4294967297"), StartsWith("mission.seed: must be an integer"));
}

TEST(ConfigFile, RefusesANameThatIsNotAmongTheOptions) {
  EXPECT_EQ(RefusalOf("[map]\nweight_policy = 'median'"),
            "map.weight_policy: must be one of best_view | per_scan | per_point, is 'median'");
}

TEST(ConfigFile, RefusesContradictoryLimits) {
  EXPECT_EQ(RefusalOf("[lidar]\nrange_max_m = 0.1"),
            "lidar.range_max_m must exceed lidar.range_min_m (0.42), is 0.1");
  EXPECT_EQ(RefusalOf("[map]\ntruncation_m = 0.2"),
            "map.truncation_m must exceed map.voxel_m (0.25), is 0.2");
  EXPECT_EQ(RefusalOf("[mission]\nvolume_min_m = [0, 0, 0]\nvolume_max_m = [1, -1, 1]"),
            "mission.volume_max_m[1] must exceed mission.volume_min_m[1] (0), is -1");
  EXPECT_THAT(RefusalOf("[mission]\nvolume_min_m = [0, 0, 0]"), HasSubstr("both or neither"));
  EXPECT_EQ(RefusalOf("[dynamics]\nstep_s = 0.1"),
            "smoother.guard_hz must not exceed 1 / dynamics.step_s (10), is 20");
  EXPECT_EQ(RefusalOf("[quality]\nd_star_m = 0.5"),
            "quality.d_star_m must exceed quality.eta_m (0.5), is 0.5");
}

TEST(ConfigFile, RefusesASpawnBelowTheKnownFreeBallOrOutsideTheVolume) {
  EXPECT_EQ(RefusalOf("[mission]\nvolume_min_m = [0, 0, -1]\nvolume_max_m = [9, 9, 9]\nspawns_m = [[0, 0, "
                      "3], [0, 4, 1]]"),
            "mission.spawns_m[1]: z must be at least 1.25, is 1");
  EXPECT_THAT(
      RefusalOf("[mission]\nvolume_min_m = [0, 0, 0]\nvolume_max_m = [9, 9, 9]\nspawns_m = [[-1, 0, 3]]"),
      StartsWith("mission.spawns_m[0]: must lie inside the mission volume, is [-1, 0, 3]"));
}

TEST(ConfigFile, NamesLineAndColumnOfTextThatIsNotToml) {
  EXPECT_THAT(RefusalOf("[mission]\nuavs = = 3\n"), StartsWith("2:8: not TOML: "));
}

TEST(ConfigFile, RefusesARegionThatIsIncompleteOrInsideOut) {
  EXPECT_EQ(RefusalOf("[[quality.region]]\nmin_m = [0, 0, 0]"), "quality.region[0].max_m: missing");
  EXPECT_EQ(RefusalOf("[[quality.region]]\nmin = [0, 0, 0]"),
            "quality.region[0].min: unknown key; did you mean quality.region[0].min_m?");
  EXPECT_EQ(RefusalOf("[[quality.region]]\nmin_m = [2, 0, 0]\nmax_m = [1, 1, 1]\nd_star_m = 3"),
            "quality.region[0].max_m[0] must exceed quality.region[0].min_m[0] (2), is 1");
  EXPECT_THAT(RefusalOf("[quality]\nregion = 3"),
              StartsWith("quality.region: must be rows of [[quality.region]]"));
}

TEST(ConfigFile, OverridesAreTypedByTheirKeyAndTheLastWins) {
  const MissionConfig config = ParseMission(
      "[planner]\nalpha = 3",
      {"planner.alpha=4", "planner.alpha=5.5", "planner.strategy=nearest_frontier", "mission.name=7",
       "planner.balance=false", "mission.spawns_m=[[0, 0, 3]]", "launch.out=a b=c"});
  EXPECT_EQ(config.planner.alpha, 5.5);
  EXPECT_EQ(config.planner.strategy, "nearest_frontier");
  EXPECT_EQ(config.mission.name, "7");
  EXPECT_FALSE(config.planner.balance);
  EXPECT_EQ(config.mission.spawns_m.size(), 1u);
  EXPECT_EQ(config.launch.out, "a b=c");
}

TEST(ConfigFile, RefusesAnOverrideThatIsNone) {
  EXPECT_EQ(RefusalOf("", {"uavs"}), "'uavs': must be section.key=value");
  EXPECT_EQ(RefusalOf("", {"mission.uav=3"}), "mission.uav: unknown key; did you mean mission.uavs?");
  EXPECT_EQ(RefusalOf("", {"mission.uavs=three"}), "mission.uavs: cannot read the value 'three'");
  EXPECT_EQ(RefusalOf("", {"mission.uavs=99"}), "mission.uavs: must be an integer in [1, 15], is 99");
  EXPECT_EQ(RefusalOf("", {"mission.uavs=2\nx=1"}), "mission.uavs: cannot read the value '2\nx=1'");
}

}  // namespace
}  // namespace citrine

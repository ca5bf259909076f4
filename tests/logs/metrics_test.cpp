#include "logs/metrics.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace citrine::logs {
namespace {

/// The keys that users are promised, in their order.
constexpr const char* kKeys = R"(
mission world world_hash strategy uavs seed in_process pace completed stop_reason mission_time_s wall_time_s real_time_factor
makespan_m average_path_m path_m mean_speed_mps
coverage_pct precision_pct f_score_pct threshold_m
observable_coverage_pct
goal_coverage_pct object_goal_coverage_pct
surface_error_mean_m surface_error_p95_m z_sat z_bar_sat z_goal voxels_reaching_goal_pct
collisions min_obstacle_clearance_m min_uav_separation_m max_speed_mps max_acceleration_mps2
decisions replan_ms_p50 replan_ms_p95 views_p50 elements_p50 elements_given_up elements_unreachable plan_ms_p95 smoothing_ms_p95
integration_ms_p50 integration_ms_p95 imbalance_corrections corrections_per_decision
bus_bytes bus_bytes_by_channel messages_lost map_digest log_digest peak_memory_mb commit)";

TEST(Metrics, HaveThePromisedKeysInTheirOrder) {
  std::vector<std::string> promised, written;
  std::istringstream words(kKeys);
  for (std::string word; words >> word;) promised.push_back(word);
  const auto json = nlohmann::ordered_json::parse(ToJson({}));
  for (const auto& item : json.items()) written.push_back(item.key());
  EXPECT_EQ(written, promised);
}

TEST(Metrics, ThatDoNotApplyAreNull) {
  const auto json = nlohmann::ordered_json::parse(ToJson({}));
  for (const char* key :
       {"world_hash", "makespan_m", "coverage_pct", "collisions", "log_digest", "peak_memory_mb"})
    EXPECT_TRUE(json[key].is_null()) << key;
  EXPECT_TRUE(json["path_m"].is_array());
  EXPECT_TRUE(json["bus_bytes_by_channel"].is_object());
}

TEST(Metrics, ComeBackFromTheirText) {
  Metrics metrics;
  metrics.mission = "house \"of\" µ";
  metrics.pace = 0;
  metrics.path_m = {258.2, 200.9};
  metrics.coverage_pct = 80.73;
  metrics.collisions = 0;
  metrics.bus_bytes_by_channel = {{"CLOCK", 12}, {"UAV1_STATE", 99}};
  metrics.map_digest = "0123456789abcdef";
  const std::string text = ToJson(metrics);
  EXPECT_THAT(text, testing::HasSubstr("\"pace\": \"max\""));
  EXPECT_THAT(text, testing::HasSubstr("\"coverage_pct\": 80.73,"));
  EXPECT_EQ(ToJson(MetricsFromJson(text)), text);
}

TEST(Metrics, WriteWhatIsNotFiniteAsNull) {
  Metrics metrics;
  metrics.min_uav_separation_m = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(nlohmann::json::parse(ToJson(metrics))["min_uav_separation_m"].is_null());
}

TEST(Metrics, OfAnotherKindAreRefusedByName) {
  try {
    MetricsFromJson(R"({"coverage_pct": "most"})");
    FAIL() << "text was taken for a number";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("coverage_pct"));
  }
  EXPECT_THROW(MetricsFromJson("{"), std::runtime_error);
  EXPECT_THROW(MetricsFromJson("[]"), std::runtime_error);
}

}  // namespace
}  // namespace citrine::logs

#include "modules/mission_report/ground_truth.h"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "core/config/config_file.h"

namespace citrine {
namespace {

/// A mission of the project; its world's path is of the project as well.
MissionConfig MissionOf(const std::string& name) {
  std::ifstream in(std::string(CITRINE_SOURCE_DIR) + "/missions/" + name + ".toml");
  std::ostringstream text;
  text << in.rdbuf();
  MissionConfig config = ParseMission(text.str(), {});
  config.mission.world = std::string(CITRINE_SOURCE_DIR) + "/" + config.mission.world;
  return config;
}

/// A truth whose UAVs begin nowhere: what can be observed does not matter here, and is not looked for.
GroundTruth TruthOf(const std::string& name) { return GroundTruth(MissionOf(name), {}, ""); }

class TrueMesh : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Worlds, TrueMesh, ::testing::Values("smoke", "structure", "house"),
                         [](const auto& world) { return world.param; });

TEST_P(TrueMesh, ScoresInFullAndNoMeshAtAllNothing) {
  const GroundTruth truth = TruthOf(GetParam());
  const auto full = truth.Score(truth.world().mesh), none = truth.Score({});
  EXPECT_EQ(full->coverage_pct, 100);
  EXPECT_EQ(full->precision_pct, 100);
  EXPECT_EQ(full->f_score_pct, 100);
  EXPECT_LT(*full->surface_error_p95_m, 1e-4);  // floats of tens of metres
  EXPECT_EQ(none->coverage_pct, 0);
  EXPECT_EQ(none->precision_pct, 0);
  EXPECT_EQ(none->f_score_pct, 0);
}

TEST(GroundTruth, SeesMoreAndMoreAndInTheEndWhatAllScansSaw) {
  MissionConfig config = MissionOf("smoke");
  const GroundTruth truth(config, {{-5, -5, 3}, {5, 5, 3}}, "");
  std::vector<logs::Timed<Pose>> scans, later;
  for (int k = 0; k < 30; ++k) {
    Pose X_WS;
    X_WS.p = Eigen::Vector3d(-5 + k / 3.0, -5, 3);
    scans.push_back({k * 200'000, X_WS});
    later.push_back({(30 - k) * 200'000, X_WS});
  }
  const auto seen = truth.SeenFrom(scans);
  ASSERT_EQ(seen.all_pct.size(), 6u);  // 29 x 0.2 s
  for (std::size_t k = 1; k < seen.all_pct.size(); ++k)
    EXPECT_GE(seen.all_pct[k].second, seen.all_pct[k - 1].second);
  EXPECT_GT(seen.all_pct.front().second, 1);
  EXPECT_LT(seen.all_pct.back().second, 100);
  EXPECT_EQ(seen.all_pct.back().second, truth.SeenFrom(later).all_pct.back().second);
  EXPECT_EQ(truth.SeenFrom({}).all_pct.back().second, 0);
}

}  // namespace
}  // namespace citrine

#include <cstring>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/map/ply.h"
#include "tests/support/analytic_scene.h"
#include "tests/support/citrine_command.h"
#include "tests/support/scratch_folder.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// Twelve scans of a box on the ground, as KITTI would have recorded them.
class CommandFuse : public ::testing::Test {
 protected:
  CommandFuse() {
    fs::create_directories(folder_ / "scans");
    scene_.AddHalfSpace(Eigen::Vector3d::UnitZ(), 0);
    scene_.AddBox({2, -2, 0}, {4, 2, 3});
    std::ofstream poses(folder_ / "poses.tum");
    for (int i = 0; i < 12; ++i) {
      const Pose X_WS{{-3 + 0.2 * i, 0.5 * i - 3, 2.5}, Eigen::Quaterniond::Identity()};
      poses << 0.1 * i << ' ' << X_WS.p.x() << ' ' << X_WS.p.y() << ' ' << X_WS.p.z() << " 0 0 0 1\n";
      const LidarScan scan = scene_.Scan(X_WS);
      std::vector<float> numbers;
      for (int row = 0; row < scan.model.rows; ++row)
        for (int col = 0; col < scan.model.cols; ++col)
          if (const float r = scan.ranges_m[row * scan.model.cols + col]; r > 0) {
            const Eigen::Vector3f p = (scan.model.Direction(row, col) * r).cast<float>();
            numbers.insert(numbers.end(), {p.x(), p.y(), p.z(), 0.5f});
          }
      points_ += numbers.size() / 4;
      std::ofstream file(folder_ / "scans" / (std::to_string(1000 + i) + ".bin"), std::ios::binary);
      file.write(reinterpret_cast<const char*>(numbers.data()),
                 static_cast<std::streamsize>(4 * numbers.size()));
    }
  }
  CommandResult Fuse(const std::string& more = "") {
    const std::string at = folder_.string();
    return RunCitrine("fuse --scans " + at + "/scans --poses " + at + "/poses.tum --out " + at + "/out " +
                      more);
  }

  const ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path();
  test::AnalyticScene scene_;
  std::size_t points_ = 0;
};

TEST_F(CommandFuse, MakesAMeshNearTheTrueSurfaceAMapAndTheMetricsOfIt) {
  const CommandResult result = Fuse("--range-max 10");
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const TriMesh mesh = ReadPly((folder_ / "out/mesh.ply").string());
  ASSERT_GT(mesh.triangles.size(), 2000u);
  int far = 0;
  for (const Eigen::Vector3f& p_W : mesh.vertices_W)
    far += std::abs(scene_.Distance(p_W.cast<double>())) > 0.125;
  EXPECT_LT(far, 0.03 * static_cast<double>(mesh.vertices_W.size()));  // at the limbs of the box
  EXPECT_GT(fs::file_size(folder_ / "out/map.bt"), 1000u);
  std::ifstream file(folder_ / "out/metrics.json");
  const nlohmann::json metrics = nlohmann::json::parse(file);
  EXPECT_EQ(metrics["scans"], 12);
  EXPECT_NEAR(metrics["points"].get<double>(), static_cast<double>(points_),
              0.001 * static_cast<double>(points_));
  for (const char* key : {"integration_ms_p50", "integration_ms_p95", "points_per_s", "mesh_ms", "map_bytes"})
    EXPECT_GT(metrics[key].get<double>(), 0) << key;
}

TEST_F(CommandFuse, RefusesWhatIsDamagedOrDoesNotMatchAndSaysWhere) {
  std::ofstream(folder_ / "poses.tum", std::ios::app) << "1.2 0 0 2.5 0 0 0 1\n";
  CommandResult result = Fuse();
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.output, HasSubstr("poses.tum:13: 13 poses, but 12 scans"));
  std::ofstream(folder_ / "poses.tum", std::ios::app) << "1.3 0 zero 2.5 0 0 0 1\n";
  result = Fuse();
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.output, HasSubstr("poses.tum:14: \"zero\" is no number"));
  result = Fuse("--voxel 5");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.output, HasSubstr("--voxel = 5"));
}

TEST_F(CommandFuse, RefusesACloudThatIsCutShort) {
  fs::resize_file(folder_ / "scans/1003.bin", 1001);
  const CommandResult result = Fuse();
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.output, HasSubstr("1003.bin: 1001 bytes"));
}

}  // namespace
}  // namespace citrine

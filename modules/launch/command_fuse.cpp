#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>

#include <nlohmann/json.hpp>

#include "core/map/occupancy_tree.h"
#include "core/map/ply.h"
#include "fusion/cloud_files.h"
#include "fusion/cloud_fuser.h"
#include "fusion/pose_file.h"
#include "fusion/surface_mesh.h"
#include "logs/percentile.h"
#include "modules/launch/commands.h"
#include "modules/runtime/stopwatch.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

/// One line that is redrawn: a bar, how many of how many, and points a second. Not drawn where nobody looks.
class FuseBar {
 public:
  explicit FuseBar(std::size_t scans) : scans_(scans), drawn_(isatty(STDERR_FILENO) == 1) {}
  void Show(std::size_t done, double points_per_s) {
    if (!drawn_) return;
    constexpr std::size_t kWidth = 40;
    const std::size_t full = kWidth * done / scans_;
    std::fprintf(stderr, "\r\033[K[%s%s] %zu/%zu scans, %.1f M points/s", std::string(full, '#').c_str(),
                 std::string(kWidth - full, '.').c_str(), done, scans_, 1e-6 * points_per_s);
    if (done == scans_) std::fputc('\n', stderr);
    std::fflush(stderr);
  }

 private:
  std::size_t scans_;
  bool drawn_;
};

void Check(const FuseOptions& options) {
  const auto refuse = [](const char* what, double value, const char* allowed) {
    throw std::runtime_error(std::string(what) + " = " + nlohmann::json(value).dump() + ": " + allowed);
  };
  if (!(options.voxel_m >= 0.02 && options.voxel_m <= 2))
    refuse("--voxel", options.voxel_m, "0.02 to 2 m is allowed");
  if (!(options.truncation_m > options.voxel_m && options.truncation_m <= 10))
    refuse("--truncation", options.truncation_m, "more than a voxel, and up to 10 m, is allowed");
  if (!(options.range_max_m >= 1 && options.range_max_m <= 200))
    refuse("--range-max", options.range_max_m, "1 to 200 m is allowed");
}

}  // namespace

int Fuse(const FuseOptions& asked) {
  FuseOptions options = asked;
  if (options.truncation_m == 0) options.truncation_m = 2 * options.voxel_m;
  Check(options);
  const std::vector<std::string> files = fusion::FindCloudFiles(options.scans);
  const std::vector<Pose> X_WS = fusion::ReadTumPoses(options.poses);
  if (files.size() != X_WS.size())
    throw std::runtime_error(options.poses + ":" + std::to_string(std::min(files.size(), X_WS.size()) + 1) +
                             ": " + std::to_string(X_WS.size()) + " poses, but " +
                             std::to_string(files.size()) + " scans in " + options.scans);
  fs::create_directories(options.out);

  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  fusion::CloudFuser fuser({.voxel_m = options.voxel_m,
                            .truncation_m = options.truncation_m,
                            .range_max_m = options.range_max_m,
                            .threads = threads});
  std::vector<float> integration_ms;
  double spent_ms = 0, points = 0;
  FuseBar bar(files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::vector<Eigen::Vector3f> points_S = fusion::ReadCloud(files[i]);
    const Stopwatch stopwatch;
    points += static_cast<double>(fuser.Integrate(points_S, X_WS[i]));
    integration_ms.push_back(static_cast<float>(stopwatch.ms()));
    spent_ms += integration_ms.back();
    bar.Show(i + 1, 1e3 * points / std::max(spent_ms, 1e-3));
  }

  const Stopwatch stopwatch;
  const TriMesh mesh = fusion::SurfaceMesh(fuser.map());
  const double mesh_ms = stopwatch.ms();
  const fs::path out = options.out;
  WritePly((out / "mesh.ply").string(), mesh);
  OccupancyTree octree;
  octree.Add(fuser.map());
  octree.WriteBt((out / "map.bt").string());
  const nlohmann::ordered_json metrics{
      {"scans", files.size()},
      {"points", static_cast<std::int64_t>(points)},
      {"integration_ms_p50", logs::Percentile(integration_ms, 50).value_or(0)},
      {"integration_ms_p95", logs::Percentile(integration_ms, 95).value_or(0)},
      {"points_per_s", 1e3 * points / std::max(spent_ms, 1e-3)},
      {"mesh_ms", mesh_ms},
      {"map_bytes", fuser.map().bytes()}};
  std::ofstream file(out / "metrics.json");
  file << metrics.dump(2) << '\n';
  if (!file.flush()) throw std::runtime_error((out / "metrics.json").string() + ": cannot be written");
  std::printf("%zu scans, %.0f points, %zu triangles\n  %s\n", files.size(), points, mesh.triangles.size(),
              (out / "mesh.ply").c_str());
  return kCompleted;
}

}  // namespace citrine

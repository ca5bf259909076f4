#include "modules/launch/result_folder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace citrine {
namespace {

namespace fs = std::filesystem;

constexpr std::array kResults{"metrics.json", "mesh.ply",    "mesh.png",    "map.bt",     "map.tsdf",
                              "progress.csv", "topdown.png", "topdown.mp4", "report.html"};

bool IsOldResult(const fs::path& path) {
  const std::string name = path.filename();
  return std::find(kResults.begin(), kResults.end(), name) != kResults.end() ||
         (path.extension() == ".tum" && name.starts_with("uav"));
}

/// Bytes that a log may take until the time limit; less if it is split and old parts go.
double LargestLog_bytes(const MissionConfig& config) {
  constexpr double kUav_bytesps = 200e3;  // scans of 32 x 512 beams, the map's share and all the rest
  const LaunchSection& launch = config.launch;
  const double whole = kUav_bytesps * config.mission.uavs * config.mission.time_limit_s;
  const bool bounded = launch.log_split_mb > 0 && launch.log_keep > 0;
  return bounded ? std::min(whole, launch.log_split_mb * 1e6 * (launch.log_keep + 1)) : whole;
}

/// Recorded and put in order, a log is there twice for a moment.
void WarnOfTheDisk(const MissionConfig& config) {
  std::error_code unknown;
  const double free_bytes = static_cast<double>(fs::space(config.launch.out, unknown).available);
  const double needed_bytes = LargestLog_bytes(config) * (config.launch.in_process ? 1 : 2);
  if (unknown || free_bytes >= needed_bytes) return;
  std::fprintf(
      stderr,
      "citrine: disk: %.0f MB free in %s; the log may take %.0f MB until the time limit\n  mend: --out DIR "
      "on another disk, or --set launch.log_split_mb=50 --set launch.log_keep=2\n",
      free_bytes / 1e6, config.launch.out.c_str(), needed_bytes / 1e6);
}

/// [m] from which level ground is seen at the nearest, by a level UAV at its least height.
double NearestGround_m(const MissionConfig& config) {
  constexpr double kInside_rad = EIGEN_PI / 180;  // of the field of view's limit, as everywhere in planning
  const double down_rad = -config.lidar.model.elevation_min_rad - kInside_rad;
  const double height_m = config.uav.limits.radius_m + config.map.voxel_m / 2;
  return height_m / std::sin(std::clamp<double>(down_rad, kInside_rad, EIGEN_PI / 2));
}

void WarnOfTheGoal(const MissionConfig& config) {
  const double d_star_m = config.quality.d_star_m, ground_m = NearestGround_m(config);
  if (ground_m < d_star_m) return;
  std::fprintf(
      stderr,
      "citrine: quality.d_star_m: %g: flown level and clear of it, the ground is seen from %.2f m at "
      "the nearest; it cannot reach its goal, and the UAVs will search long\n  mend: "
      "quality.d_star_m = %.1f, or a LiDAR that looks down further\n",
      d_star_m, ground_m, std::ceil(10 * ground_m + 1) / 10);
}

}  // namespace

std::string PrepareResultFolder(const ResolvedMission& mission) {
  const fs::path out = mission.config.launch.out;
  fs::create_directories(out);
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(out))
    if (IsOldResult(entry.path())) old.push_back(entry.path());
  for (const fs::path& path : old) fs::remove(path);
  for (const char* log : {"mission.lcmlog", "recorded.lcmlog"})
    while (!LogFiles(out / log).empty())  // one file, and then parts, should there be both
      for (const std::string& part : LogFiles(out / log)) fs::remove(part);

  WarnOfTheDisk(mission.config);
  WarnOfTheGoal(mission.config);
  const fs::path file = out / "mission.toml";
  std::ofstream text(file);
  text << mission.toml << std::flush;
  if (!text) throw std::runtime_error(file.string() + ": cannot be written");
  return file;
}

LogSplit SplitOf(const LaunchSection& launch) {
  return {static_cast<std::int64_t>(launch.log_split_mb * 1e6), launch.log_keep};
}

}  // namespace citrine

#include "modules/launch/result_folder.h"

#include <algorithm>
#include <array>
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

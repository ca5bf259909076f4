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

constexpr std::array kResults{"metrics.json", "mission.lcmlog", "recorded.lcmlog", "mesh.ply",   "map.bt",
                              "progress.csv", "topdown.png",    "topdown.mp4",     "report.html"};

bool IsOldResult(const fs::path& path) {
  return std::find(kResults.begin(), kResults.end(), path.filename()) != kResults.end() ||
         (path.extension() == ".tum" && path.filename().string().starts_with("uav"));
}

}  // namespace

std::string PrepareResultFolder(const ResolvedMission& mission) {
  const fs::path out = mission.config.launch.out;
  fs::create_directories(out);
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(out))
    if (IsOldResult(entry.path())) old.push_back(entry.path());
  for (const fs::path& path : old) fs::remove(path);

  const fs::path file = out / "mission.toml";
  std::ofstream text(file);
  text << mission.toml << std::flush;
  if (!text) throw std::runtime_error(file.string() + ": cannot be written");
  return file;
}

}  // namespace citrine

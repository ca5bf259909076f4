#include "modules/launch/mission_file.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/config/config.h"
#include "core/config/nearest_name.h"
#include "modules/launch/project.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> MissionNames() {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(ProjectFolder() / "missions", none))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

MissionFile ReadMissionFile(const std::string& mission) {
  for (const fs::path& path : {fs::path(mission), fs::path("missions") / (mission + ".toml"),
                               ProjectFolder() / "missions" / (mission + ".toml")}) {
    if (!fs::is_regular_file(path)) continue;
    std::ifstream in(path);
    std::stringstream text;
    text << in.rdbuf();
    if (!in) throw ConfigError(path.string() + ": cannot be read");
    return {fs::absolute(path), text.str()};
  }
  const std::string nearest = NearestName(mission, MissionNames());
  throw ConfigError(mission + ": neither a mission file nor a name in missions/" +
                    (nearest.empty() ? "" : "; did you mean " + nearest + "?"));
}

std::string FindWorldFile(const std::string& world, const std::string& mission_path) {
  std::string looked;
  for (const fs::path& folder : {fs::current_path(), fs::path(mission_path).parent_path(), ProjectFolder()}) {
    const fs::path path = folder / world;
    if (fs::is_regular_file(path)) return fs::canonical(path);
    looked += (looked.empty() ? "" : ", ") + folder.string();
  }
  throw ConfigError("mission.world: no file '" + world + "' in " + looked);
}

}  // namespace citrine

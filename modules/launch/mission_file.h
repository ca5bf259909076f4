#pragma once

#include <string>

namespace citrine {

/// A mission file and what the command line changes in it.
struct MissionFile {
  std::string path;
  std::string toml;
};

/// Finds a mission: a file, or a name in missions/ of this folder or of the project.
/// @throws ConfigError naming the nearest mission that there is
MissionFile ReadMissionFile(const std::string& mission);

/// Where a world file is: relative to the present folder (of `--world`), to the mission file, or to the
/// project.
/// @throws ConfigError naming the places that were looked at
std::string FindWorldFile(const std::string& world, const std::string& mission_path);

}  // namespace citrine

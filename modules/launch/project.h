#pragma once

#include <filesystem>
#include <string>

namespace citrine {

/// The folder of the sources from which this program was built: there are its worlds/ and missions/.
const std::filesystem::path& ProjectFolder();

/// The commit of the project, and whether its files differ from it; "" outside of git.
struct SourceVersion {
  std::string commit;
  bool dirty = false;
};
SourceVersion ReadSourceVersion();

/// Those of the project's packages.txt that are not installed, separated by spaces.
std::string MissingPackages();

}  // namespace citrine

#pragma once

#include <filesystem>
#include <string>
#include <vector>

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
/// The same of these.
std::string MissingPackages(const std::vector<std::string>& packages);

}  // namespace citrine

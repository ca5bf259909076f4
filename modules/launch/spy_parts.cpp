#include "modules/launch/spy_parts.h"

#include <cstdlib>
#include <filesystem>

#include "modules/launch/project.h"
#include "viz/display.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

constexpr const char* kInTheTerminal = "; for a terminal view use: ./citrine top";

std::string MissingOnes(const fs::path& jar) {
  if (const std::string packages = MissingPackages({"liblcm-java", "libjchart2d-java"}); !packages.empty())
    return "needs " + packages + "\n  mend: sudo apt-get install --no-install-recommends " + packages +
           " default-jre" + kInTheTerminal;
  if (std::system("java -version >/dev/null 2>&1") != 0)
    return std::string("needs java\n  mend: sudo apt-get install default-jre") + kInTheTerminal;
  if (const std::string why = viz::WhyNoDisplay(); !why.empty())
    return "needs a display: " + why + kInTheTerminal;
  if (!fs::exists(jar)) return "needs " + jar.string() + "\n  mend: ./citrine spy, which builds it";
  return {};
}

std::string NewerThan(const fs::path& jar) {
  std::string newer;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(ProjectFolder() / "lcmtypes", none))
    if (entry.path().extension() == ".lcm" && entry.last_write_time() > fs::last_write_time(jar, none))
      newer += (newer.empty() ? "" : ", ") + entry.path().stem().string();
  if (newer.empty()) return {};
  return newer + ": newer than " + jar.string() +
         ", so their channels would not decode\n  mend: ./citrine spy, which builds it anew";
}

}  // namespace

SpyParts FindSpyParts() {
  const fs::path jar =
      fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "share/java/citrine-types.jar";
  SpyParts parts{jar, MissingOnes(jar), {}};
  if (fs::exists(jar)) parts.stale = NewerThan(jar);
  return parts;
}

}  // namespace citrine

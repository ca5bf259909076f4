#include <map>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"

namespace citrine {
namespace {

// core knows itself, a verb core and itself, modules everything; LCM and the words are met in modules alone.
std::set<std::string> Forbidden(const std::string& layer) {
  if (layer == "modules") return {"tests"};
  std::set<std::string> forbidden = {"tests", "lcm", "citrine_lcm"};
  for (const std::string& other : kLayers)
    if (other != "core" && other != layer) forbidden.insert(other);
  return forbidden;
}

TEST(Layering, HoldsInEveryInclude) {
  const std::regex include(R"(^#include [<"]([a-z_]+)/.*)");
  int includes = 0;
  for (const std::string& layer : kLayers) {
    const auto forbidden = Forbidden(layer);
    for (const SourceFile& file : FilesUnder(layer, {".h", ".cpp"})) {
      for (const std::string& line : file.lines) {
        std::smatch match;
        if (!std::regex_match(line, match, include)) continue;
        ++includes;
        EXPECT_FALSE(forbidden.contains(match[1]))
            << file.path << ": " << layer << "/ may not know: " << line;
      }
    }
  }
  EXPECT_GT(includes, 500) << "the test no longer sees the tree";
}

TEST(Layering, MeetsEachThirdPartyLibraryInOnePlace) {
  const std::map<std::string, std::vector<std::string>> places = {
      {"CLI", {"modules/"}},
      {"assimp", {"sim/world"}},
      {"boost", {"logs/statistics"}},
      {"embree3", {"sim/lidar", "logs/"}},
      {"google", {"modules/mcap_export"}},
      {"lcm", {"modules/runtime"}},
      {"nlopt", {"planner/trajectory"}},
      {"octomap", {}},  // tests alone
      {"ode", {"sim/dynamics"}},
      {"opencv2", {"viz/"}},
      {"sdf", {"sim/world"}},
      {"toml++", {"core/config"}},
      {"xcb", {"viz/display"}},
      {"zlib", {"logs/mcap"}},
      {"zstd", {"modules/codec", "logs/mcap"}},
  };
  const std::regex include(R"(^#include [<"]([A-Za-z0-9_+]+)[/.].*)");
  for (const std::string& layer : kLayers)
    for (const SourceFile& file : FilesUnder(layer, {".h", ".cpp"}))
      for (const std::string& line : file.lines) {
        std::smatch match;
        if (!std::regex_match(line, match, include) || !places.contains(match[1])) continue;
        bool allowed = false;
        for (const std::string& place : places.at(match[1])) allowed |= file.path.starts_with(place);
        EXPECT_TRUE(allowed) << file.path << ": " << line;
      }
}

}  // namespace
}  // namespace citrine

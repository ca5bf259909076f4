#include <regex>

#include <gtest/gtest.h>

#include "tests/architecture/source_tree.h"

namespace citrine {
namespace {

constexpr std::size_t kMaxLines = 400;  // of a file that can be read at one go

std::vector<SourceFile> AllCode() {
  std::vector<SourceFile> all;
  for (const std::string& layer : kLayers)
    for (SourceFile& file : FilesUnder(layer, {".h", ".cpp"})) all.push_back(std::move(file));
  return all;
}

void ExpectNowhere(const std::string& pattern, const std::vector<std::string>& allowed_under = {}) {
  const std::regex regex(pattern);
  for (const SourceFile& file : AllCode()) {
    bool allowed = false;
    for (const std::string& place : allowed_under) allowed |= file.path.starts_with(place);
    for (std::size_t i = 0; i < file.lines.size() && !allowed; ++i)
      EXPECT_FALSE(std::regex_search(file.lines[i], regex))
          << file.path << ":" << i + 1 << ": " << file.lines[i];
  }
}

TEST(Manners, EveryMainOfAModuleIsOneLine) {
  int mains = 0;
  for (const SourceFile& file : FilesUnder("modules", {"main.cpp"})) {
    if (file.path.starts_with("modules/launch/") || file.path.starts_with("modules/mission_report/"))
      continue;
    EXPECT_LE(file.lines.size(), 5u) << file.path;
    if (file.path.starts_with("modules/recorder/")) continue;  // one line, but it is no module
    ++mains;
    EXPECT_TRUE(file.lines.back().starts_with("int main(int argc, char** argv) { return citrine::RunModule<"))
        << file.path;
  }
  EXPECT_EQ(mains, 6);
}

TEST(Manners, NoFileIsTooLongToBeRead) {
  for (const SourceFile& file : AllCode()) EXPECT_LE(file.lines.size(), kMaxLines) << file.path;
}

TEST(Manners, NothingIsLeftForLater) { ExpectNowhere(R"(\b(TODO|FIXME|XXX|HACK)\b)"); }

TEST(Manners, NoPathOfSomebodysMachine) { ExpectNowhere(R"("/(home|root|tmp|work|mnt|opt|usr|Users)\b)"); }

TEST(Manners, NoWallClockDecides) {
  ExpectNowhere(R"(\b(steady_clock|system_clock|high_resolution_clock|gettimeofday|clock_gettime)\b)",
                {"modules/runtime/cpu_stopwatch.h", "modules/runtime/stopwatch.h",
                 "modules/runtime/wall_pacer.h", "modules/launch/"});
}

TEST(Manners, NoChanceWithoutASeed) {
  ExpectNowhere(R"(\b(random_device|mt19937|std::rand|srand|drand48)\b)");
}

TEST(Manners, NoHashOrderDecides) { ExpectNowhere(R"(\bunordered_(map|set)\b)"); }

TEST(Manners, NoChannelIsNamedOutsideTheTable) {
  ExpectNowhere(
      R"re("(UAV.*_)?(CLOCK|STEP_DONE|LIDAR_SCAN|POINT_CLOUD|MAP_BLOCKS|MAP_SUMMARY|MAP_OCTREE|MISSION_PROGRESS)")re"
      R"re(|"(UAV.*_)?(FLEET_STATUS|FLEET_ASSIGNMENT|FLIGHT_STATUS|TRAJECTORY|MISSION_CONFIG|MODULE_HEALTH)")re",
      {"modules/channels.h"});
}

}  // namespace
}  // namespace citrine

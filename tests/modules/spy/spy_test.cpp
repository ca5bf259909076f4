#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/citrine_command.h"
#include "viz/read_png.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;

std::string Missing() {
  for (const char* program : {"java", "xvfb-run", "Xvfb"})
    if (RunCommandLine(std::string("command -v ") + program).exit_code != 0)
      return std::string(program) + " is not there (packages-tools.txt)";
  if (!fs::exists(fs::path(CITRINE_BIN_DIR).parent_path() / "share/java/citrine-types.jar"))
    return "the jar of types was not built: no javac, or no lcm.jar";
  if (RunCommandLine("dpkg-query -W libjchart2d-java liblcm-java").exit_code != 0)
    return "lcm-spy or its charts are not there (packages-tools.txt)";
  if (RunCommandLine("unshare -n true || unshare -rn true").exit_code != 0)
    return "this host allows no private networks";
  return {};
}

/// Pixels of a colour within the noise of anti-aliasing.
int CountColour(const viz::Image& image, int red, int green, int blue) {
  int count = 0;
  for (std::size_t i = 0; i + 2 < image.bgr.size(); i += 3)
    count += std::abs(image.bgr[i] - blue) + std::abs(image.bgr[i + 1] - green) +
                 std::abs(image.bgr[i + 2] - red) <
             12;
  return count;
}

// lcm-spy on a virtual screen, in the private network of a mission that flies meanwhile.
TEST(Spy, DecodesEveryChannelAndShowsTheMissionFromAbove) {
  if (const std::string missing = Missing(); !missing.empty()) GTEST_SKIP() << missing;
  const std::string out = ::testing::TempDir() + "/run", picture = ::testing::TempDir() + "/spy.png";
  const std::string launch = std::string(CITRINE_BIN_DIR) + "/launch ";
  const CommandResult spy = RunCommandLine(
      launch + "run smoke --isolate --out " + out +
      " >/dev/null 2>&1 & launcher=$!; for i in $(seq 300); do [ -e " + out +
      "/running ] && break; sleep 0.1; done; sleep 4; xvfb-run -a -s '-screen 0 1600x900x24' " + launch +
      "spy --run " + out + " --screenshot " + picture +
      " --after 10; code=$?; kill -INT $launcher; wait $launcher; exit $code");
  EXPECT_EQ(spy.exit_code, 0) << "a channel does not decode:\n" << spy.output;
  for (const char* channel : {"CLOCK +clock_t", "MAP_BLOCKS +map_blocks_t", "UAV2_LIDAR_SCAN +lidar_scan_t",
                              "MODULE_HEALTH +module_health_t", "UAV1_TRAJECTORY +trajectory_t"})
    EXPECT_THAT(spy.output, ContainsRegex(std::string(channel) + " +[0-9]+ messages\n"));
  ASSERT_TRUE(fs::exists(picture)) << spy.output;
  const viz::Image screen = viz::ReadPng(picture);
  // A UAV is a disc of at least 8 pixels of radius.
  EXPECT_GT(CountColour(screen, 0xD5, 0x5E, 0x00), 100) << "UAV 1";
  EXPECT_GT(CountColour(screen, 0x00, 0x72, 0xB2), 100) << "UAV 2";
}

}  // namespace
}  // namespace citrine

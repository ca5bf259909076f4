#include "modules/topdown_renderer/topdown_renderer_module.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/yard_flight.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

class TopdownRendererOnTheBus : public ::testing::Test, protected test::YardFlight<TopdownRendererModule> {
 protected:
  TopdownRendererOnTheBus() {
    config.launch.out = ::testing::TempDir() + "citrine_topdown_renderer";
    fs::remove_all(config.launch.out);
    fs::create_directories(config.launch.out);
  }
  ~TopdownRendererOnTheBus() override { fs::remove_all(config.launch.out); }

  fs::path picture() const { return fs::path(config.launch.out) / "topdown.png"; }
  std::string Picture() const {
    std::ifstream file(picture(), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

TEST_F(TopdownRendererOnTheBus, DrawsEveryTenSecondsAndAtTheEndWhatWasSaid) {
  Begin(0);
  Fly(9.9);
  EXPECT_FALSE(fs::exists(picture()));
  Fly(0.2);
  const std::string empty = Picture();
  ASSERT_TRUE(empty.starts_with("\x89PNG"));
  SayMap();
  SayState(1);
  Fly(1);
  EXPECT_EQ(Picture(), empty) << "not yet due";
  Tick(true);
  EXPECT_NE(Picture(), empty);
  EXPECT_EQ(health.last_error(), "");
}

TEST_F(TopdownRendererOnTheBus, DrawsLessOftenWhereAMissionPassesFasterThanTheWall) {
  config.launch.pace = 2;
  Begin(0);
  Fly(19.9);
  EXPECT_FALSE(fs::exists(picture()));
  Fly(0.2);
  EXPECT_TRUE(fs::exists(picture()));
}

TEST_F(TopdownRendererOnTheBus, SaysNothing) {
  Begin(0);
  SayMap();
  SayState(1);
  Fly(10.2);
  Tick(true);
  EXPECT_EQ(bus.counts().bytes_said, 0);
}

TEST_F(TopdownRendererOnTheBus, DropsAndCountsAStateThatIsNoneAndDrawsOn) {
  Begin(0);
  citrine_lcm::uav_state_t message = Encode(UavState());
  message.p_WB[0] = std::numeric_limits<double>::quiet_NaN();
  peers.Publish(channels::kUavState, 1, message);
  Fly(0.1);
  Tick(true);
  EXPECT_EQ(bus.counts().bad, 1);
  EXPECT_TRUE(fs::exists(picture()));
}

TEST_F(TopdownRendererOnTheBus, LivesWithAResultFolderThatIsGone) {
  Begin(0);
  fs::remove_all(config.launch.out);
  Fly(10.2);
  EXPECT_NE(health.last_error(), "");
}

}  // namespace
}  // namespace citrine

#include <gtest/gtest.h>

#include "sim/lidar/observability.h"
#include "tests/sim/box_world.h"

namespace citrine::sim {
namespace {

class SeenByScans : public testing::Test {
 protected:
  SurfaceSample At(float x, float y, float z) const {
    return {{x, y, z}, Eigen::Vector3f::UnitZ(), 1, false};
  }
  std::vector<std::uint8_t> Seen(const std::vector<SurfaceSample>& samples, const std::vector<Pose>& X_WS,
                                 double d_star_m = 4.5) const {
    std::vector<std::uint8_t> seen;
    for (const int first : First(samples, X_WS, d_star_m)) seen.push_back(first >= 0);
    return seen;
  }
  std::vector<int> First(const std::vector<SurfaceSample>& samples, const std::vector<Pose>& X_WS,
                         double d_star_m = 4.5) const {
    return FirstSeenBy(samples, X_WS, scene_, LidarModel(),
                       QualityGoals(QualityGoal::FromDistance(d_star_m)));
  }
  RayScene scene_{BoxWorld({{"ground", Box(-20, -20, -1, 20, 20, 0)}, {"wall", Box(1, -3, 0, 1.5, 3, 2)}})};
};

TEST_F(SeenByScans, NeedsRangeAndFieldOfViewAndAFreeLine) {
  const Pose X_WS{{0, 0, 1}, Eigen::Quaterniond::Identity()};
  EXPECT_EQ(Seen({At(-2, 0, 0), At(-0.5f, 0, 0), At(-6, 0, 0), At(2, 0, 0), At(1, 0, 0.5f), At(0.2f, 0, 1)},
                 {X_WS}),
            (std::vector<std::uint8_t>{1, 0, 0, 0, 1, 0}));
}

TEST_F(SeenByScans, LooksThroughTheFieldOfViewAsTheSensorWasTilted) {
  const SurfaceSample below = At(-0.8f, 0, 0);  // 51 degrees down
  const Pose level{{0, 0, 1}, Eigen::Quaterniond::Identity()};
  // Pitching by -0.4 rad about y lowers the side of -x.
  const Pose tilted{{0, 0, 1}, Eigen::Quaterniond(Eigen::AngleAxisd(-0.4, Eigen::Vector3d::UnitY()))};
  EXPECT_EQ(Seen({below}, {level}).at(0), 0);
  EXPECT_EQ(Seen({below}, {tilted}).at(0), 1);
}

TEST_F(SeenByScans, GathersAllScans) {
  const std::vector<SurfaceSample> samples{At(-2, 0, 0), At(4, 0, 0), At(10, 0, 0)};
  EXPECT_EQ(Seen(samples,
                 {{{0, 0, 1}, Eigen::Quaterniond::Identity()}, {{6, 0, 1}, Eigen::Quaterniond::Identity()}}),
            (std::vector<std::uint8_t>{1, 1, 1}));
  EXPECT_EQ(Seen(samples, {}), (std::vector<std::uint8_t>{0, 0, 0}));
}

TEST_F(SeenByScans, TellsTheFirstScanThatSawEach) {
  const Pose left{{0, 0, 1}, Eigen::Quaterniond::Identity()},
      right{{6, 0, 1}, Eigen::Quaterniond::Identity()};
  const std::vector<SurfaceSample> samples{At(-2, 0, 0), At(8, 0, 0), At(15, 0, 0)};
  EXPECT_EQ(First(samples, {left, left, right, right}), (std::vector<int>{0, 2, -1}));
}

TEST_F(SeenByScans, GoesNoFurtherThanTheSensorWhateverTheGoal) {
  EXPECT_EQ(Seen({At(-9, 0, 0), At(-10.5f, 0, 0)}, {{{0, 0, 1}, Eigen::Quaterniond::Identity()}}, 50),
            (std::vector<std::uint8_t>{1, 0}));
}

}  // namespace
}  // namespace citrine::sim

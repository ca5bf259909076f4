#include "planner/strategy/flown_poses.h"

#include <array>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/random.h"
#include "planner/view/well_seen.h"
#include "tests/planner/path/synthetic_map.h"

namespace citrine::planner {
namespace {

using Eigen::Vector3d;

/// A wall at x = 8, and an element in its middle.
class FlownPosesTest : public testing::Test {
 protected:
  FlownPosesTest() {
    element.voxel = map.grid().IndexOf({7.9, 6, 4});
    element.linear = map.grid().Linear(element.voxel);
    element.p_W = map.grid().Centre(element.voxel);
    element.normal_W = -Vector3d::UnitX();
    element.d_star_m = 4.5;
  }
  int Looks(Utime before, int enough = 100) const {
    return flown.Looks(map, element, window, before, enough);
  }

  PlanningMap map = MapOf({12, 12, 8}, [](const Vector3d& p) { return 8 - p.x(); });
  SensorWindow window{LidarModel()};
  Element element;
  FlownPoses flown{2};
};

TEST_F(FlownPosesTest, CountsPosesHalfAMetreApartFromWhichALookShouldHaveSettledIt) {
  for (int k = 0; k <= 60; ++k) flown.Add(1, Pose{{4.5, 3 + 0.1 * k, 4}}, k);
  int expected = 0;
  for (double y = 3; y < 9.01; y += 0.5) expected += WellSeen(map, element, window, {4.5, y, 4});
  EXPECT_GT(expected, 5);
  EXPECT_NEAR(Looks(1000), expected, 1);  // steps of a tenth add up to half a metre with rounding
  EXPECT_EQ(Looks(1000, 3), 3);
  EXPECT_EQ(Looks(0), 0);
  EXPECT_LT(Looks(30), Looks(1000));
}

TEST_F(FlownPosesTest, DoesNotCountPosesTooFarBehindOrTiltedAway) {
  flown.Add(1, Pose{{2.5, 6, 4}}, 1);
  flown.Add(1, Pose{{10, 6, 4}}, 2);
  EXPECT_EQ(Looks(10), 0);
  const Vector3d level_W(4.5, 6, 4);
  const Eigen::Quaterniond nose_down(Eigen::AngleAxisd(0.6, Vector3d::UnitY()));  // by 34 degrees
  flown.Add(1, Pose{level_W, nose_down}, 3);
  EXPECT_EQ(Looks(10), 0);
  flown.Add(2, Pose{level_W}, 4);
  EXPECT_EQ(Looks(10), 1);
}

TEST_F(FlownPosesTest, CountsOnLongFlightsWhatAPassOverAllPosesCounts) {
  Random random(7);
  std::array<Vector3d, 2> at_W{Vector3d(2, 6, 4), Vector3d(6, 3, 4)};
  std::vector<std::pair<Vector3d, Utime>> poses_W;
  for (Utime now = 0; now < 3000; ++now) {
    const auto uav = static_cast<std::size_t>(now % 2);
    const Vector3d step(random.Normal(), random.Normal(), random.Normal());
    const Vector3d p_W = at_W[uav] + 0.6 * step.normalized();
    if (!Eigen::AlignedBox3d(Vector3d(-8, -8, 1), Vector3d(7, 20, 7)).contains(p_W)) continue;
    at_W[uav] = p_W;
    poses_W.emplace_back(p_W, now);
    flown.Add(static_cast<int>(uav) + 1, Pose{p_W}, now);
  }
  for (const Utime before : {100, 777, 3000}) {
    int expected = 0;
    for (const auto& [p_W, at] : poses_W) expected += at < before && WellSeen(map, element, window, p_W);
    EXPECT_EQ(Looks(before, 10000), expected);
    EXPECT_GT(expected, before == 3000 ? 20 : -1);
  }
}

TEST_F(FlownPosesTest, IgnoresUavsThatAreNotOfTheFleet) {
  flown.Add(0, Pose{{4.5, 6, 4}}, 1);
  flown.Add(3, Pose{{4.5, 6, 4}}, 1);
  EXPECT_EQ(Looks(10), 0);
}

}  // namespace
}  // namespace citrine::planner

#include "viz/relief.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/viz/test_scene.h"

namespace citrine::viz {
namespace {

using Eigen::Vector3d;

const Eigen::AlignedBox3d kVolume(Vector3d(-8, -8, 0), Vector3d(8, 8, 8));

/// A slope with a table on it.
double Slope(const Vector3d& p) { return (p.z() - 1 - 0.25 * p.x()) / std::sqrt(1 + 0.0625); }
double SlopeAndTable(const Vector3d& p) {
  const Vector3d q = (p - Vector3d(3, 3, 4)).cwiseAbs() - Vector3d(1.5, 1.5, 1);
  return std::min(Slope(p), q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0));
}

struct ReliefOfTable : testing::Test {
  std::unique_ptr<PlanningMap> map = MapOf(kVolume, SlopeAndTable, [](const Vector3d& p) {
    return p.y() < -6 ? 20.0 : p.y() < 0 ? 9.0 : 3.0;
  });
  Scene scene;
  Relief relief;

  ReliefOfTable() {
    scene.map = map.get();
    relief = ReliefOf(scene);
  }
  std::size_t CellAt(double x, double y) const {
    return relief.Cell(static_cast<int>((x - relief.corner_W.x()) / relief.cell_m),
                       relief.height - 1 - static_cast<int>((y - relief.corner_W.y()) / relief.cell_m));
  }
};

TEST_F(ReliefOfTable, CoversTheMissionVolume) {
  EXPECT_EQ(relief.width, 64);
  EXPECT_EQ(relief.height, 64);
  EXPECT_NEAR(relief.corner_W.x(), -8, 1e-9);
  EXPECT_NEAR(relief.corner_W.y(), -8, 1e-9);
}

TEST_F(ReliefOfTable, FindsTheHeightOfTheHighestSurfaceBelowAVoxel) {
  for (double x = -6.9; x < 0; x += 0.25) {
    const double centre_x = -8 + (std::floor((x + 8) / 0.25) + 0.5) * 0.25;
    // The slope leans by 14 degrees, so its distance reads 3 % short; the code of a distance adds 2 mm.
    EXPECT_NEAR(relief.top_m[CellAt(x, 2)], 1 + 0.25 * centre_x, 0.01) << x;
  }
  EXPECT_NEAR(relief.top_m[CellAt(3, 3)], 5, 0.01);
  EXPECT_NEAR(relief.highest_m, 5, 0.01);
}

TEST_F(ReliefOfTable, LooksBelowTheCeiling) {
  scene.ceiling_m = 2.5;
  relief = ReliefOf(scene);
  EXPECT_NEAR(relief.top_m[CellAt(3.1, 3.1)], 1.78, 0.05);
}

TEST_F(ReliefOfTable, TellsTheUnknownFromTheKnown) {
  EXPECT_EQ(relief.seen[CellAt(0, -7)], Relief::Seen::kNothing);
  EXPECT_EQ(relief.seen[CellAt(0, 5)], Relief::Seen::kSurface);
}

TEST_F(ReliefOfTable, SharesConfidenceOutOfItsGoal) {
  EXPECT_NEAR(relief.share[CellAt(0, -3)], 0.25, 0.005);  // 4.5^2 / 9^2, within the weight code's 1 %
  EXPECT_EQ(relief.share[CellAt(0, 5)], 1);
}

TEST_F(ReliefOfTable, IsLitFromTheNorthWestAndThrowsAShadowToTheSouthEast) {
  EXPECT_LT(relief.light[CellAt(5.0, 1.0)], 0.75 * relief.light[CellAt(-3, 3)]);   // behind the table
  EXPECT_NEAR(relief.light[CellAt(1.0, 5.0)], relief.light[CellAt(-3, 3)], 0.05);  // in front of it
}

TEST(Relief, OfNoMapIsEmpty) { EXPECT_EQ(ReliefOf(Scene{}).width, 0); }

}  // namespace
}  // namespace citrine::viz

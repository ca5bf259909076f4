#include "planner/view/dispersion.h"

#include <array>

#include <gtest/gtest.h>

#include "core/random.h"

namespace citrine::planner {
namespace {

TEST(SphereOverlap, IsTheVolumeThatAGridCounts) {
  const double cell = 0.02;
  for (const auto& [a, b, d] :
       {std::array{1.0, 1.0, 0.7}, std::array{1.0, 0.6, 1.1}, std::array{1.0, 0.5, 0.55}}) {
    int inside = 0;
    for (double x = -1 + cell / 2; x < 1; x += cell)
      for (double y = -1 + cell / 2; y < 1; y += cell)
        for (double z = -1 + cell / 2; z < 1; z += cell)
          inside += x * x + y * y + z * z < a * a && (x - d) * (x - d) + y * y + z * z < b * b;
    EXPECT_NEAR(SphereOverlap(a, b, d), inside * cell * cell * cell,
                5e-3);  // 0.2 % for the cells cut by the surface
  }
  EXPECT_EQ(SphereOverlap(1, 1, 2), 0);
  EXPECT_NEAR(SphereOverlap(2, 1, 0.5), 4.0 / 3 * EIGEN_PI, 1e-12);
}

TEST(Dispersion, IsOneAloneAndForDistantOthersAndZeroOnTopOfThem) {
  const QualityGoals goals;
  EXPECT_EQ(Dispersion({0, 0, 0}, {}, goals), 1);
  EXPECT_EQ(Dispersion({0, 0, 0}, {{9.1, 0, 0}, {0, 20, 0}}, goals), 1);
  EXPECT_NEAR(Dispersion({1, 2, 3}, {{1, 2, 3}, {1, 2, 3}}, goals), 0, 1e-12);
  // Two equal spheres of radius R at d share 1 - 3d/(4R) + d^3/(16 R^3) of one; the second UAV is far.
  const double d = 2, r = 4.5;
  EXPECT_NEAR(Dispersion({0, 0, 0}, {{d, 0, 0}, {50, 0, 0}}, goals),
              1 - 0.5 * (1 - 3 * d / (4 * r) + d * d * d / (16 * r * r * r)), 1e-12);
}

TEST(Dispersion, TakesEachSpheresRegionAndTheLargestForTheDenominator) {
  const QualityGoals goals(QualityGoal::FromDistance(4),
                           {{Eigen::AlignedBox3d(Eigen::Vector3d(5, -1, -1), Eigen::Vector3d(9, 1, 1)),
                             QualityGoal::FromDistance(2)}});
  EXPECT_NEAR(Dispersion({0, 0, 0}, {{5.5, 0, 0}}, goals),
              1 - SphereOverlap(4, 2, 5.5) / SphereOverlap(4, 4, 0), 1e-12);
}

}  // namespace
}  // namespace citrine::planner

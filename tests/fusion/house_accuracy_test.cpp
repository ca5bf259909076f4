#include <gtest/gtest.h>

#include "fusion/surface_mesh.h"
#include "fusion/tsdf_integrator.h"
#include "tests/support/house_flight.h"
#include "tests/support/map_score.h"
#include "tests/support/ray_integrator.h"

namespace citrine::fusion {
namespace {

// The best figures of six published mappers on a scene like this one, all at once.
constexpr double kErrorMean_m = 0.029, kErrorP95_m = 0.09, kSeen_pct = 98.7;

class HouseAccuracy : public testing::TestWithParam<std::pair<int, int>> {};

TEST_P(HouseAccuracy, IsThatOfTheBestMappersAndNoWorseThanOfEveryRayByItself) {
  const auto [rows, cols] = GetParam();
  const test::HouseFlight flight;
  const VoxelGrid grid(0.25, test::kHouseVolume_W, 0.75);
  TsdfMap projective(grid, 0.5), exact(grid, 0.5);
  TsdfIntegrator integrator(projective, WeightPolicy::kBestView);
  test::RayIntegrator rays(exact);
  for (const LidarScan& scan : flight.Scans(rows, cols)) {
    integrator.Integrate(scan);
    rays.Integrate(scan);
  }
  const auto seen_W = test::SeenSurface(flight.Scans(rows, cols, 0));
  const test::MapScore ours = test::Score(SurfaceMesh(projective), *flight.scene(), seen_W, 0.25);
  const test::MapScore oracle = test::Score(SurfaceMesh(exact), *flight.scene(), seen_W, 0.25);
  EXPECT_LE(ours.error_mean_m, kErrorMean_m);
  EXPECT_LE(ours.error_p95_m, kErrorP95_m);
  EXPECT_GE(ours.seen_pct, kSeen_pct);
  EXPECT_LE(ours.error_mean_m, 1.05 * oracle.error_mean_m);
  EXPECT_LE(ours.error_p95_m, 1.05 * oracle.error_p95_m);
  EXPECT_GE(ours.seen_pct, 0.95 * oracle.seen_pct);
}
INSTANTIATE_TEST_SUITE_P(Beams, HouseAccuracy,
                         testing::Values(std::pair{64, 720}, std::pair{32, 512}, std::pair{16, 360}));

}  // namespace
}  // namespace citrine::fusion

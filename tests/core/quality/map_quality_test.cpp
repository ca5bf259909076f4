#include "core/quality/map_quality.h"

#include <gtest/gtest.h>

#include "tests/support/random_map.h"

namespace citrine {
namespace {

TEST(MapQuality, IsTheMeanOfEquations2To4OverTheSurfaceVoxels) {
  testing::RandomMap world(2);
  ActiveSurface surface(world.map.grid(), world.map.quantisation(), QualityGoals());
  surface.Update(world.map);
  const double w_star = QualityGoal().w_star;
  double sum = 0, sum_sat = 0;
  int voxels = 0;
  for (std::size_t i = 0; i < surface.classes().size(); ++i) {
    if (surface.At(i) != SurfaceClass::kReached && surface.At(i) != SurfaceClass::kLqse) continue;
    sum += world.map.weight(i);
    sum_sat += std::min(world.map.weight(i), w_star);
    ++voxels;
  }
  const MapQuality quality = QualityOf(world.map, surface, false);
  EXPECT_NEAR(quality.z_bar, sum / voxels, 1e-12);
  EXPECT_NEAR(quality.z_bar_sat, sum_sat / voxels, 1e-4 * w_star);  // w >= 0.9999 w* counts as w*
  EXPECT_NEAR(quality.z_goal, w_star, 1e-12);
  EXPECT_EQ(quality.z_sat(), 0);  // incomplete elements remain
  EXPECT_EQ(QualityOf(world.map, surface, true).z_sat(), quality.z_bar_sat);

  const MissionProgress progress = ProgressOf(world.map, surface, true, 9);
  EXPECT_EQ(progress.surface_voxels, voxels);
  EXPECT_EQ(progress.voxels_at_goal + progress.elements_lqse, voxels);
  EXPECT_EQ(static_cast<std::size_t>(progress.elements_ise + progress.elements_lqse),
            surface.elements().size());
  EXPECT_GT(progress.known_pct, 0);
  EXPECT_LT(progress.known_pct, 100);
}

}  // namespace
}  // namespace citrine

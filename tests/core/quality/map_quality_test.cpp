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
  const MapQuality quality = QualityOf(world.map, surface, false).whole;
  EXPECT_NEAR(quality.z_bar, sum / voxels, 1e-12);
  EXPECT_NEAR(quality.z_bar_sat, sum_sat / voxels, 1e-4 * w_star);  // w >= 0.9999 w* counts as w*
  EXPECT_NEAR(quality.z_goal, w_star, 1e-12);
  EXPECT_EQ(quality.z_sat(), 0);  // incomplete elements remain
  EXPECT_EQ(QualityOf(world.map, surface, true).whole.z_sat(), quality.z_bar_sat);

  const MissionProgress progress = ProgressOf(world.map, surface, true, 9);
  EXPECT_EQ(progress.surface_voxels, voxels);
  EXPECT_EQ(progress.voxels_at_goal + progress.elements_lqse, voxels);
  EXPECT_EQ(static_cast<std::size_t>(progress.elements_ise + progress.elements_lqse),
            surface.elements().size());
  EXPECT_GT(progress.known_pct, 0);
  EXPECT_LT(progress.known_pct, 100);
}

TEST(MapQuality, OfThePartsAddsUpToThatOfTheWhole) {
  testing::RandomMap world(2);
  const QualityGoals goals(
      QualityGoal{}, {{{Eigen::Vector3d(2, 2, 0), Eigen::Vector3d(7, 7, 8)}, QualityGoal::FromDistance(3)},
                      {{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(5, 5, 8)}, QualityGoal::FromDistance(6)}});
  ActiveSurface surface(world.map.grid(), world.map.quantisation(), goals);
  surface.Update(world.map);
  const MissionProgress progress = ProgressOf(world.map, surface, false, 1);
  ASSERT_EQ(progress.parts.size(), 3u);
  std::int32_t voxels = 0, at_goal = 0, ise = 0;
  double sum_sat = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const MissionProgress::Part& part = progress.parts[i];
    EXPECT_GT(part.surface_voxels, 0);
    EXPECT_NEAR(part.z_goal, goals.OfPart(i).w_star, 1e-12);  // one goal all over the part
    EXPECT_EQ(part.z_sat, part.elements_ise == 0 ? part.z_bar_sat : 0);
    voxels += part.surface_voxels, at_goal += part.voxels_at_goal, ise += part.elements_ise;
    sum_sat += part.z_bar_sat * part.surface_voxels;
  }
  EXPECT_EQ(voxels, progress.surface_voxels);
  EXPECT_EQ(at_goal, progress.voxels_at_goal);
  EXPECT_EQ(ise, progress.elements_ise);
  EXPECT_NEAR(sum_sat / voxels, progress.z_bar_sat, 1e-12);
}

}  // namespace
}  // namespace citrine

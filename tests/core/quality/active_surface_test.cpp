#include "core/quality/active_surface.h"

#include <gtest/gtest.h>

#include "core/grid/neighbours.h"
#include "core/quality/confidence.h"
#include "tests/support/random_map.h"

namespace citrine {
namespace {

using testing::RandomMap;

QualityGoals TwoRegions() {
  return QualityGoals(QualityGoal::FromDistance(4.5),
                      {{Eigen::AlignedBox3d(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(5, 5, 8)),
                        QualityGoal::FromDistance(8)}});
}

/// Definitions 1 and 3 by the letter.
SurfaceClass ByDefinition(const PlanningMap& map, const QualityGoals& goals, const VoxelIndex& v) {
  const VoxelGrid& grid = map.grid();
  if (!grid.Inside(v)) return SurfaceClass::kNone;
  const auto state = [&](const VoxelIndex& n) { return map.state(grid.Linear(n)); };
  bool unknown6 = false, empty6 = false, occupied18 = false;
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const int steps = std::abs(x) + std::abs(y) + std::abs(z);
        const VoxelIndex n = v + VoxelIndex(x, y, z);
        if (steps == 0 || !grid.Inside(n)) continue;
        unknown6 |= steps == 1 && state(n) == VoxelState::kUnknown;
        empty6 |= steps == 1 && state(n) == VoxelState::kEmpty;
        occupied18 |= steps <= 2 && state(n) == VoxelState::kOccupied;
      }
  if (state(v) == VoxelState::kEmpty)
    return unknown6 && occupied18 ? SurfaceClass::kIse : SurfaceClass::kNone;
  const std::size_t i = grid.Linear(v);
  if (state(v) == VoxelState::kUnknown || std::abs(map.distance_m(i)) >= grid.voxel_m() || !empty6)
    return SurfaceClass::kNone;
  return map.weight(i) >= 0.9999 * goals.At(grid.Centre(v)).w_star ? SurfaceClass::kReached
                                                                   : SurfaceClass::kLqse;
}

void ExpectByDefinition(const PlanningMap& map, const ActiveSurface& surface) {
  std::vector<std::uint32_t> elements;
  for (std::size_t i = 0; i < map.grid().num_voxels(); ++i) {
    const SurfaceClass expected = ByDefinition(map, surface.goals(), map.grid().FromLinear(i));
    ASSERT_EQ(surface.At(i), expected) << "voxel " << i;
    if (expected >= SurfaceClass::kLqse) elements.push_back(static_cast<std::uint32_t>(i));
  }
  EXPECT_EQ(surface.elements(), elements);
  EXPECT_GT(surface.Count(SurfaceClass::kIse), 50);
  EXPECT_GT(surface.Count(SurfaceClass::kLqse), 50);
  EXPECT_GT(surface.Count(SurfaceClass::kReached), 50);
}

TEST(ActiveSurface, FollowsTheDefinitionsInEveryVoxel) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    RandomMap world(seed);
    ActiveSurface surface(world.map.grid(), world.map.quantisation(), TwoRegions());
    surface.Update(world.map);
    ExpectByDefinition(world.map, surface);
  }
}

TEST(ActiveSurface, MaintainedBlockByBlockEqualsAComputationFromScratch) {
  RandomMap world(7);
  ActiveSurface surface(world.map.grid(), world.map.quantisation(), TwoRegions());
  surface.Update(world.map);
  world.Reveal();
  for (int round = 0; round < 20; ++round) {
    for (int k = 0; k < 5; ++k)
      world.Say(static_cast<int>(world.random().Below(world.map.grid().num_blocks())));
    world.map.Update();
    if (round % 3 == 2) continue;  // a hearer may miss an update
    surface.Update(world.map);
    ActiveSurface scratch(world.map.grid(), world.map.quantisation(), TwoRegions());
    scratch.Update(world.map);
    ASSERT_EQ(surface.classes(), scratch.classes());
    ASSERT_EQ(surface.elements(), scratch.elements());
    for (const SurfaceClass c : {SurfaceClass::kReached, SurfaceClass::kLqse, SurfaceClass::kIse})
      ASSERT_EQ(surface.Count(c), scratch.Count(c));
  }
}

TEST(ActiveSurface, NotesDiscoveriesButNotOtherChanges) {
  RandomMap world(7);
  ActiveSurface surface(world.map.grid(), world.map.quantisation(), QualityGoals());
  surface.Update(world.map);
  const std::int64_t before = surface.last_discovery();
  for (int block = 0; block < world.map.grid().num_blocks(); ++block) world.Say(block);
  world.map.Update();
  EXPECT_TRUE(surface.Update(world.map));
  EXPECT_EQ(surface.last_discovery(), before);
  world.Reveal();
  for (int block = 0; block < world.map.grid().num_blocks(); ++block) world.Say(block);
  world.map.Update();
  surface.Update(world.map);
  EXPECT_EQ(surface.last_discovery(), world.map.revision());
}

TEST(Confidence, IsThatOfTheReferenceDistanceAndTheDistanceIsCutToTheRange) {
  EXPECT_DOUBLE_EQ(Confidence(4.5), 1 / 20.25);
  EXPECT_NEAR(ReferenceDistance(Confidence(4.5), 10), 4.5, 1e-12);
  EXPECT_DOUBLE_EQ(ReferenceDistance(1e-6, 10), 10);
}

}  // namespace
}  // namespace citrine

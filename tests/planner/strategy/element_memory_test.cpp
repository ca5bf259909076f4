#include "planner/strategy/element_memory.h"

#include <gtest/gtest.h>

#include "planner/strategy/looks.h"
#include "tests/support/random_map.h"

namespace citrine::planner {
namespace {

class ElementMemoryTest : public ::testing::Test {
 protected:
  ElementMemoryTest() { surface.Update(world.map); }
  /// Says the whole map again with fresh random weights.
  void SayAll() {
    for (int block = 0; block < world.map.grid().num_blocks(); ++block) world.Say(block);
    world.map.Update();
    surface.Update(world.map);
    memory.Update(world.map, surface);
  }
  std::uint32_t AnIse() const {
    for (const std::uint32_t voxel : surface.elements())
      if (surface.At(voxel) == SurfaceClass::kIse) return voxel;
    return 0;
  }
  void LookInVain(std::uint32_t voxel) { memory.Judge(world.map, surface, memory.Note(world.map, voxel)); }

  testing::RandomMap world{6};
  ActiveSurface surface{world.map.grid(), world.map.quantisation(), QualityGoals()};
  ElementMemory memory{world.map.grid(), 10};
};

TEST_F(ElementMemoryTest, GivesUpAfterTwoLooksThatChangeNothing) {
  const std::uint32_t voxel = AnIse();
  LookInVain(voxel);
  EXPECT_FALSE(memory.Skips(voxel));
  EXPECT_EQ(memory.Attempts(voxel), 1);
  LookInVain(voxel);
  EXPECT_TRUE(memory.Skips(voxel));
  EXPECT_EQ(memory.given_up(), 1);
  SayAll();  // other weights, the same classes
  EXPECT_TRUE(memory.Skips(voxel));
}

TEST_F(ElementMemoryTest, TakesAnElementBackWhenTheClassesAroundItChange) {
  const std::uint32_t voxel = AnIse();
  LookInVain(voxel);
  LookInVain(voxel);
  while (surface.At(voxel) == SurfaceClass::kIse) {
    world.Reveal();
    SayAll();
  }
  EXPECT_FALSE(memory.Skips(voxel));
  EXPECT_EQ(memory.given_up(), 0);
}

TEST_F(ElementMemoryTest, GivesUpASurfaceThatLooksDoNotRaiseThoughClassesAroundItFlicker) {
  for (const std::uint32_t voxel : surface.elements()) {
    if (surface.At(voxel) != SurfaceClass::kLqse) continue;
    ElementMemory::Before before = memory.Note(world.map, voxel);
    ++before.around;
    memory.Judge(world.map, surface, before);
    EXPECT_EQ(memory.Attempts(voxel), 1);
    memory.Judge(world.map, surface, before);
    EXPECT_TRUE(memory.Skips(voxel));
    return;
  }
  FAIL() << "no LQSE";
}

TEST_F(ElementMemoryTest, ALookThatRaisedTheWeightIsNotInVain) {
  for (const std::uint32_t voxel : surface.elements()) {
    if (surface.At(voxel) != SurfaceClass::kLqse) continue;
    ElementMemory::Before before = memory.Note(world.map, voxel);
    --before.weight_code;
    memory.Judge(world.map, surface, before);
    EXPECT_EQ(memory.Attempts(voxel), 0);
    return;
  }
  FAIL() << "no LQSE";
}

TEST_F(ElementMemoryTest, UnreachableElementsReturnAfterADiscoveryNearThem) {
  const std::uint32_t voxel = surface.elements().front();
  memory.MarkUnreachable(voxel, world.map.revision());
  EXPECT_EQ(memory.unreachable(), 1);
  SayAll();
  EXPECT_TRUE(memory.Skips(voxel));
  world.Reveal();
  SayAll();
  EXPECT_FALSE(memory.Skips(voxel));
  memory.MarkUnreachable(voxel, 0);
  EXPECT_EQ(memory.RetestBefore(1), 1);
  EXPECT_FALSE(memory.Skips(voxel));
}

TEST_F(ElementMemoryTest, TakesBackExactlyWhatADiscoveryIsWithinTheRangeOfInBlocks) {
  const VoxelGrid& grid = world.map.grid();
  constexpr double kRange_m = 2.5;  // two blocks
  for (int round = 0; round < 4; ++round) {
    ElementMemory near{grid, kRange_m};
    const std::vector<std::uint32_t> marked = surface.elements();
    const std::int64_t marked_at = world.map.revision();
    for (const std::uint32_t voxel : marked) near.MarkUnreachable(voxel, marked_at);
    world.Reveal();
    SayAll();
    near.Update(world.map, surface);
    for (const std::uint32_t voxel : marked) {
      const Eigen::Vector3i at = grid.FromLinear(voxel) / kBlockSide;
      bool discovered = false;
      for (int block = 0; block < grid.num_blocks(); ++block) {
        const Eigen::Vector3i off = grid.BlockOrigin(block) / kBlockSide - at;
        discovered |= off.cwiseAbs().maxCoeff() <= 2 && surface.discovered(block) > marked_at;
      }
      ASSERT_EQ(near.Skips(voxel), surface.At(voxel) >= SurfaceClass::kLqse && !discovered);
    }
  }
}

TEST_F(ElementMemoryTest, LooksAreJudgedOnceTheMapHasHadTimeToAnswer) {
  const std::uint32_t voxel = AnIse();
  Looks looks(1.0);
  looks.Add({memory.Note(world.map, voxel)}, world.map.revision(), 0);
  std::vector<std::uint32_t> under_judgement;
  looks.AppendTo(under_judgement);
  EXPECT_EQ(under_judgement, std::vector<std::uint32_t>{voxel});
  EXPECT_FALSE(looks.Judge(world.map, surface, FromSeconds(1.5), memory));  // no map since
  SayAll();
  EXPECT_FALSE(looks.Judge(world.map, surface, FromSeconds(0.9), memory));
  EXPECT_TRUE(looks.Judge(world.map, surface, FromSeconds(1.0), memory));
  EXPECT_TRUE(looks.empty());
  EXPECT_EQ(memory.Attempts(voxel), 1);
}

}  // namespace
}  // namespace citrine::planner

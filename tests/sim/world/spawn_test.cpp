#include "sim/world/spawn.h"

#include <gmock/gmock.h>

#include "tests/sim/box_world.h"

namespace citrine::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

class Spawn : public testing::Test {
 protected:
  World world_ = BoxWorld({{"ground", Box(-12, -12, -0.1, 12, 12, 0)}, {"block", Box(4, -12, 0, 12, 12, 6)}});
  RayScene scene_{world_};
  Eigen::AlignedBox3d volume_W_ = Box(-12, -12, 0, 12, 12, 10);
};

TEST_F(Spawn, PlacesTheFleetInFreeSpaceApartFromEachOther) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto spawns_W = PlaceSpawns(scene_, volume_W_, 4, {}, 0.5, seed);
    ASSERT_EQ(spawns_W.size(), 4u);
    for (std::size_t i = 0; i < spawns_W.size(); ++i) {
      EXPECT_TRUE(FreeToStart(scene_, volume_W_, spawns_W[i])) << spawns_W[i].transpose();
      for (std::size_t j = 0; j < i; ++j) EXPECT_GE((spawns_W[i] - spawns_W[j]).norm(), kSpawnApart_m);
    }
  }
}

TEST_F(Spawn, MovesGivenStartsBySeedWithinTheJitter) {
  const std::vector<Eigen::Vector3d> given{{-8, -6, 4}, {-8, 6, 4}};
  const auto a = PlaceSpawns(scene_, volume_W_, 2, given, 0.5, 3),
             b = PlaceSpawns(scene_, volume_W_, 2, given, 0.5, 4);
  EXPECT_EQ(a, PlaceSpawns(scene_, volume_W_, 2, given, 0.5, 3));
  EXPECT_NE(a, b);
  for (int i = 0; i < 2; ++i) EXPECT_LE((a[i] - given[i]).lpNorm<Eigen::Infinity>(), 0.5);
}

TEST_F(Spawn, KeepsJitteredStartsFreeWhereThereIsNoRoom) {
  const std::vector<Eigen::Vector3d> given{{0, 0, 2.25}};
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    EXPECT_TRUE(FreeToStart(scene_, volume_W_, PlaceSpawns(scene_, volume_W_, 1, given, 0.5, seed).at(0)));
}

TEST_F(Spawn, RefusesAStartNearASurfaceAndNamesAFreePlaceInstead) {
  EXPECT_THAT(
      [&] {
        PlaceSpawns(scene_, volume_W_, 2, {{0, 0, 3}, {3, 0, 3}}, 0, 1);
      },
      ThrowsMessage<WorldError>(AllOf(HasSubstr("UAV 2 cannot start at (3.00, 0.00, 3.00)"),
                                      HasSubstr("1.00 m from a surface"),
                                      HasSubstr("nearest free position"))));
}

TEST_F(Spawn, RefusesAStartThatIsLowOrOutsideOrInsideASolid) {
  EXPECT_THAT(
      [&] {
        PlaceSpawns(scene_, volume_W_, 1, {{0, 0, 2}}, 0, 1);
      },
      ThrowsMessage<WorldError>(HasSubstr("lower than 2.25 m")));
  EXPECT_THAT(
      [&] {
        PlaceSpawns(scene_, volume_W_, 1, {{0, 13, 3}}, 0, 1);
      },
      ThrowsMessage<WorldError>(HasSubstr("outside the mission volume")));
  EXPECT_THAT(
      [&] {
        PlaceSpawns(scene_, volume_W_, 1, {{8, 0, 3}}, 0, 1);
      },
      ThrowsMessage<WorldError>(HasSubstr("inside a solid")));
}

TEST_F(Spawn, RefusesStartsOnTopOfEachOtherAndTooFewOfThem) {
  EXPECT_THAT(
      [&] {
        PlaceSpawns(scene_, volume_W_, 2, {{0, 0, 3}, {0.5, 0, 3}}, 0, 1);
      },
      ThrowsMessage<WorldError>(HasSubstr("UAV 1 starts less than")));
  EXPECT_THAT(
      [&] {
        PlaceSpawns(scene_, volume_W_, 2, {{0, 0, 3}}, 0, 1);
      },
      ThrowsMessage<WorldError>(HasSubstr("1 starts for 2 UAVs")));
}

TEST(SpawnInASmallVolume, SaysForHowManyThereIsRoom) {
  const World world = BoxWorld({{"ground", Box(-3, -3, -0.1, 3, 3, 0)}});
  const RayScene scene(world);
  EXPECT_THAT([&] { PlaceSpawns(scene, Box(-3, -3, 0, 3, 3, 4), 15, {}, 0.5, 1); },
              ThrowsMessage<WorldError>(HasSubstr("of 15 UAVs to start")));
}

}  // namespace
}  // namespace citrine::sim

#include <algorithm>

#include <gtest/gtest.h>

#include "sim/lidar/observability.h"
#include "sim/lidar/reachability.h"
#include "sim/world/spawn.h"
#include "sim/world/true_surface.h"
#include "tests/sim/box_world.h"

namespace citrine::sim {
namespace {

/// A world of the project in its mission volume, as a fleet of three would find it.
struct Found {
  Found(const std::string& name, const Eigen::AlignedBox3d& volume)
      : volume_W(volume),
        world(LoadWorld(CITRINE_SOURCE_DIR "/worlds/" + name + ".sdf")),
        scene(world),
        surface(SampleTrueSurface(world, scene, volume, 10, 1)),
        lattice(FindReachable(scene, volume, PlaceSpawns(scene, volume, 2, {}, 0, 1), 1.0)),
        flags(FindObservable(surface.samples, lattice, scene, LidarModel(), QualityGoals())) {}

  double AreaWithoutGround() const {
    double area_m2 = 0;
    for (const SurfaceSample& sample : surface.samples) area_m2 += sample.ground ? 0 : sample.area_m2;
    return area_m2;
  }
  double WithinGoal() const {
    return static_cast<double>(std::ranges::count(flags.within_goal, 1)) /
           static_cast<double>(flags.within_goal.size());
  }
  bool Reaches(const Eigen::Vector3d& p_W) const {
    return lattice.reachable.at(lattice.Linear(lattice.Nearest(p_W))) == 1;
  }

  Eigen::AlignedBox3d volume_W;
  World world;
  RayScene scene;
  TrueSurface surface;
  ReachableLattice lattice;
  Observability flags;
};

const Eigen::AlignedBox3d kHouse = Box(-22.5, -20, 0, 22.5, 20, 20);
const Eigen::AlignedBox3d kStructure = Box(-13, -13, 0, 13, 13, 15);

TEST(OwnWorlds, HouseCanBeFlownThroughAndNearlyAllOfItSeenFromWithinTheGoal) {
  const Found house("house", kHouse);
  EXPECT_TRUE(house.volume_W.contains(house.world.bounds_W.max()));
  EXPECT_TRUE(house.Reaches({-7.5, 8, 1.5}));  // the middle of the gate
  EXPECT_FALSE(house.Reaches({-13, 8, 3}));    // inside the house
  EXPECT_GT(house.WithinGoal(), 0.97);
}

TEST(OwnWorlds, HouseHasAGateOfThreeAndAHalfByThreeMetres) {
  const Found house("house", kHouse);
  const auto range = [&](const Eigen::Vector3f& d) {
    return house.scene.CastOne({-7.5f, 8, 1.5f}, d, 50).range_m;
  };
  EXPECT_NEAR(range(Eigen::Vector3f::UnitX()) + range(-Eigen::Vector3f::UnitX()), 3.5, 1e-4);
  EXPECT_NEAR(range(Eigen::Vector3f::UnitZ()) + range(-Eigen::Vector3f::UnitZ()), 3.0, 1e-4);
}

TEST(OwnWorlds, StructureIsLargeAndHasCeilingsAPassageAndGaps) {
  const Found structure("structure", kStructure);
  EXPECT_GE(std::ranges::count(structure.world.parts, false, &Part::ground), 60);
  EXPECT_GE(structure.AreaWithoutGround(), 900);
  double ceilings_m2 = 0;
  for (const SurfaceSample& sample : structure.surface.samples)
    if (sample.n_W.z() < -0.99f && sample.p_W.z() >= 3.5f) ceilings_m2 += sample.area_m2;
  EXPECT_GE(ceilings_m2, 80);
  for (double x = -8.5; x <= 0.5; x += 0.5)
    EXPECT_TRUE(structure.Reaches({x, 5, 2})) << x;  // the hall, end to end
  EXPECT_TRUE(structure.Reaches({-1.6, -5, 2}));     // the gap between the terraces
  EXPECT_TRUE(structure.Reaches({-3.5, 2.75, 2}));   // the door of the hall
  EXPECT_GT(structure.WithinGoal(), 0.97);
}

TEST(OwnWorlds, SmokeHasRoomForTwo) {
  const Found smoke("smoke", Box(-7, -7, 0, 7, 7, 8));
  EXPECT_GT(smoke.WithinGoal(), 0.99);
  EXPECT_GT(smoke.AreaWithoutGround(), 50);
}

}  // namespace
}  // namespace citrine::sim

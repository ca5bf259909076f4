#include "sim/lidar/reachability.h"

#include <gtest/gtest.h>

#include "tests/sim/box_world.h"

namespace citrine::sim {
namespace {

/// A corridor of 6 m, cut by a wall with a slot of the given width in its middle.
World Corridor(double slot_m) {
  return BoxWorld({{"ground", Box(-10, -3, -1, 10, 3, 0)},
                   {"ceiling", Box(-10, -3, 6, 10, 3, 7)},
                   {"left", Box(-10, 3, -1, 10, 4, 7)},
                   {"right", Box(-10, -4, -1, 10, -3, 7)},
                   {"wall_left", Box(-0.5, slot_m / 2, 0, 0.5, 3, 6)},
                   {"wall_right", Box(-0.5, -3, 0, 0.5, -slot_m / 2, 6)}});
}

bool ReachesBeyond(double slot_m) {
  const RayScene scene(Corridor(slot_m));
  const ReachableLattice lattice = FindReachable(scene, Box(-10, -3, 0, 10, 3, 6), {{-5, 0, 3}}, 1.0);
  return lattice.reachable.at(lattice.Linear(lattice.Nearest({5, 0, 3}))) == 1;
}

TEST(Reachability, PassesASlotThatIsWiderThanTheRobot) { EXPECT_TRUE(ReachesBeyond(2.1)); }
TEST(Reachability, StopsAtASlotThatIsNarrowerThanTheRobot) { EXPECT_FALSE(ReachesBeyond(1.9)); }

TEST(Reachability, TakesExactlyTheLatticePointsWithClearanceOfAnOpenWorld) {
  const Eigen::AlignedBox3d box = Box(-1, -1, 0, 1, 1, 2), volume_W = Box(-4, -4, 0, 4, 4, 5);
  const RayScene scene(BoxWorld({{"box", box}}));
  const ReachableLattice lattice = FindReachable(scene, volume_W, {{3.3, 3.3, 3}}, 1.1);
  EXPECT_EQ(lattice.size, Eigen::Vector3i(17, 17, 11));
  for (std::size_t i = 0; i < lattice.reachable.size(); ++i) {
    const Eigen::Vector3d p_W = lattice.Position(lattice.FromLinear(i));
    EXPECT_EQ(lattice.reachable[i] == 1, box.exteriorDistance(p_W) >= 1.1) << p_W.transpose();
    EXPECT_TRUE(volume_W.contains(p_W));
  }
}

TEST(Reachability, IsNothingForASpawnWithoutClearance) {
  const RayScene scene(BoxWorld({{"box", Box(-1, -1, 0, 1, 1, 2)}}));
  EXPECT_EQ(FindReachable(scene, Box(-4, -4, 0, 4, 4, 5), {{0, 0, 1}}, 1.1).num_reachable(), 0u);
}

}  // namespace
}  // namespace citrine::sim

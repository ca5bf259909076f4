#include "sim/world/edge_flaws.h"

#include <gmock/gmock.h>

#include "tests/support/scratch_folder.h"

namespace citrine::sim {
namespace {

using testing::HasSubstr;

/// A tetrahedron a metre above the ground, wound outwards, of these faces.
World Tetrahedron(const std::string& faces) {
  const ScratchFolder folder;
  const std::string ground = "v -9 -9 0\nv 9 -9 0\nv 0 9 0\nf 5 6 7\n";
  return LoadWorld(folder.Write("tetrahedron.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nv 0 0 2\n" + ground + faces));
}

TEST(EdgeFlaws, AreNoneOfAClosedSolidAndAreNotLookedForInTheGround) {
  const EdgeFlaws flaws = FindEdgeFlaws(Tetrahedron("f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"));
  EXPECT_EQ(flaws.open, 0);
  EXPECT_EQ(flaws.against, 0);
  EXPECT_EQ(flaws.inside_out, 0);
}

TEST(EdgeFlaws, CountTheRimOfAHole) {
  const EdgeFlaws flaws = FindEdgeFlaws(Tetrahedron("f 1 3 2\nf 1 2 4\nf 2 3 4\n"));
  EXPECT_EQ(flaws.open, 3);
  EXPECT_EQ(flaws.against, 0);
  EXPECT_THAT(flaws.open_at, HasSubstr("near (0.00, 0.00, 1.00)"));
}

TEST(EdgeFlaws, CountTheEdgesOfATriangleThatIsWoundAgainstItsNeighbours) {
  const EdgeFlaws flaws = FindEdgeFlaws(Tetrahedron("f 1 2 3\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"));
  EXPECT_EQ(flaws.open, 0);
  EXPECT_EQ(flaws.against, 3);
}

TEST(EdgeFlaws, NameASolidThatIsInsideOut) {
  const EdgeFlaws flaws = FindEdgeFlaws(Tetrahedron("f 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n"));
  EXPECT_EQ(flaws.against, 0);
  EXPECT_EQ(flaws.inside_out, 1);
}

}  // namespace
}  // namespace citrine::sim

#include "sim/world/edge_flaws.h"

#include <array>

#include <gmock/gmock.h>

#include "tests/support/scratch_folder.h"

namespace citrine::sim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A tetrahedron a metre above the ground, wound outwards, of these faces.
World Tetrahedron(const std::string& faces) {
  const ScratchFolder folder;
  const std::string ground = "v -9 -9 0\nv 9 -9 0\nv 0 9 0\nf 5 6 7\n";
  return LoadWorld(folder.Write("tetrahedron.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nv 0 0 2\n" + ground + faces));
}

/// What is wrong with it: open edges, edges wound against each other, solids inside out.
std::array<int, 3> FlawsOf(const std::string& faces) {
  const EdgeFlaws flaws = FindEdgeFlaws(Tetrahedron(faces));
  return {static_cast<int>(flaws.open), static_cast<int>(flaws.against), static_cast<int>(flaws.inside_out)};
}

TEST(EdgeFlaws, AreNoneOfAClosedSolidAndAreNotLookedForInTheGround) {
  EXPECT_THAT(FlawsOf("f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"), ElementsAre(0, 0, 0));
}

TEST(EdgeFlaws, CountTheRimOfAHole) {
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\n";
  EXPECT_THAT(FlawsOf(faces), ElementsAre(3, 0, 0));
  EXPECT_THAT(FindEdgeFlaws(Tetrahedron(faces)).open_at, HasSubstr("near (0.00, 0.00, 1.00)"));
}

TEST(EdgeFlaws, CountTheEdgesOfATriangleThatIsWoundAgainstItsNeighbours) {
  EXPECT_THAT(FlawsOf("f 1 2 3\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"), ElementsAre(0, 3, 0));
}

TEST(EdgeFlaws, NameASolidThatIsInsideOut) {
  EXPECT_THAT(FlawsOf("f 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n"), ElementsAre(0, 0, 1));
}

}  // namespace
}  // namespace citrine::sim

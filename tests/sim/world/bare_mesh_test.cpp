#include <gmock/gmock.h>

#include "sim/world/world.h"
#include "tests/support/scratch_folder.h"

namespace citrine::sim {
namespace {

/// A COLLADA file with one tetrahedron that reaches 1, 2 and 3 file units along x, y and z.
std::string Collada(const std::string& unit, const std::string& up) {
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>)" +
         unit + up +
         R"(</asset><library_geometries><geometry id="g" name="g"><mesh><source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 0 2 0 0 0 3</float_array>
<technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 1 2 3 2 0 3</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s" name="s"><node id="n" name="n"><translate>0 0 10</translate><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

void ExpectBox(const World& world, const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  EXPECT_TRUE((world.bounds_W.min() - min).isZero(1e-4)) << world.bounds_W.min().transpose();
  EXPECT_TRUE((world.bounds_W.max() - max).isZero(1e-4)) << world.bounds_W.max().transpose();
}

TEST(BareMesh, ObeysTheUnitOfColladaOnceAndAppliesItsNodes) {
  const ScratchFolder folder;
  ExpectBox(LoadWorld(folder.Write("m.dae",
                                   Collada("<unit name='inch' meter='0.0254'/>", "<up_axis>Z_UP</up_axis>"))),
            {0, 0, 0.254}, {0.0254, 0.0508, 0.3302});
}

TEST(BareMesh, StandsColladaUprightWhateverItsUpAxis) {
  const ScratchFolder folder;
  ExpectBox(
      LoadWorld(folder.Write("z.dae", Collada("<unit name='meter' meter='1'/>", "<up_axis>Z_UP</up_axis>"))),
      {0, 0, 10}, {1, 2, 13});
  ExpectBox(
      LoadWorld(folder.Write("y.dae", Collada("<unit name='meter' meter='1'/>", "<up_axis>Y_UP</up_axis>"))),
      {0, -13, 0}, {1, -10, 2});
}

TEST(BareMesh, TakesObjAsItIsAndDropsTrianglesWithoutArea) {
  const ScratchFolder folder;
  const World world =
      LoadWorld(folder.Write("m.obj", "v 0 0 1\nv 1 0 1\nv 0 2 4\nv 2 0 1\nf 1 2 3\nf 1 2 4\n"));
  ExpectBox(world, {0, 0, 1}, {1, 2, 4});
  EXPECT_EQ(world.mesh.triangles.size(), 1u);
}

TEST(BareMesh, TakesItsLowestLevelTrianglesForGround) {
  const ScratchFolder folder;
  const World world = LoadWorld(
      folder.Write("m.obj",
                   "v 0 0 0\nv 9 0 0.02\nv 0 9 0\nv 1 1 0\nv 2 1 0\nv 1 1 3\nv 0 0 3\nv 9 0 3\nv 0 9 3\n"
                   "f 4 5 6\nf 1 2 3\nf 7 8 9\n"));
  double ground_m2 = 0, all_m2 = world.SurfaceArea();
  for (const Part& part : world.parts)
    if (part.ground) ground_m2 += 40.5 * part.num_triangles;
  EXPECT_NEAR(ground_m2, 40.5, 1e-3);
  EXPECT_NEAR(all_m2, 40.5 + 1.5 + 40.5, 1e-3);
}

TEST(BareMesh, RefusesAFileThatIsNoMesh) {
  const ScratchFolder folder;
  EXPECT_THROW(LoadWorld(folder.Write("m.ply", "not a mesh")), WorldError);
  EXPECT_THROW(LoadWorld(folder.Write("m.txt", "not a mesh")), WorldError);
}

}  // namespace
}  // namespace citrine::sim

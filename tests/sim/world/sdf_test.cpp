#include <gmock/gmock.h>

#include "sim/world/world.h"
#include "tests/support/scratch_folder.h"

namespace citrine::sim {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::string InWorld(const std::string& models) {
  return "<?xml version='1.0'?><sdf version='1.9'><world name='w'>" + models + "</world></sdf>";
}
std::string Model(const std::string& name, const std::string& pose, const std::string& geometry,
                  const std::string& kind = "collision") {
  return "<model name='" + name + "'><static>true</static><pose>" + pose + "</pose><link name='l'><" + kind +
         " name='s'><geometry>" + geometry + "</geometry></" + kind + "></link></model>";
}
const char* const kBox = "<box><size>2 4 6</size></box>";

void ExpectBox(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& min, const Eigen::Vector3d& max) {
  EXPECT_TRUE(box.min().isApprox(min, 1e-5)) << box.min().transpose();
  EXPECT_TRUE(box.max().isApprox(max, 1e-5)) << box.max().transpose();
}

TEST(Sdf, ComposesThePosesOfModelLinkAndShape) {
  const ScratchFolder folder;
  const World world = LoadWorld(folder.Write("w.sdf", InWorld(R"(
    <model name='outer'><static>true</static><pose>10 0 0 0 0 1.5707963267948966</pose>
      <model name='inner'><pose>0 5 0 0 0 0</pose>
        <link name='l'><pose>0 0 1 0 0 0</pose><collision name='s'><pose>0 0 2 0 0 0</pose><geometry><box><size>2 4 6</size></box></geometry></collision></link>
      </model></model>)")));
  ExpectBox(world.bounds_W, {3, -1, 0}, {7, 1, 6});
  EXPECT_EQ(world.parts.at(0).name, "outer/inner/l/s");
}

TEST(Sdf, ResolvesPosesThatAreRelativeToAnotherFrame) {
  const ScratchFolder folder;
  const World world = LoadWorld(
      folder.Write("w.sdf", InWorld("<frame name='f'><pose>0 0 20 0 0 0</pose></frame><model "
                                    "name='m'><static>true</static><pose relative_to='f'>1 2 3 0 0 0</pose>"
                                    "<link name='l'><collision name='s'><geometry><box><size>2 4 "
                                    "6</size></box></geometry></collision></link></model>")));
  ExpectBox(world.bounds_W, {0, 0, 20}, {2, 4, 26});
}

TEST(Sdf, UsesVisualsOnlyWhereALinkHasNoCollision) {
  const ScratchFolder folder;
  const World world = LoadWorld(folder.Write(
      "w.sdf",
      InWorld(
          Model("seen", "0 0 0 0 0 0", kBox, "visual") +
          "<model name='both'><static>true</static><link name='l'><collision "
          "name='c'><geometry><sphere><radius>1</radius></sphere></geometry></collision>"
          "<visual name='v'><geometry><box><size>90 90 90</size></box></geometry></visual></link></model>")));
  ASSERT_EQ(world.parts.size(), 2u);
  EXPECT_EQ(world.parts[1].name, "both/l/c");
  EXPECT_LT(world.bounds_W.sizes().maxCoeff(), 7);
}

TEST(Sdf, TakesModelsNamedGroundForGroundInAnyCase) {
  const ScratchFolder folder;
  const World world = LoadWorld(folder.Write("w.sdf", InWorld(Model("Ground_Plane", "0 0 0 0 0 0", kBox) +
                                                              Model("playground", "9 0 0 0 0 0", kBox))));
  EXPECT_TRUE(world.parts.at(0).ground);
  EXPECT_FALSE(world.parts.at(1).ground);
  EXPECT_TRUE(world.PartOf(11).ground);
  EXPECT_FALSE(world.PartOf(12).ground);
}

TEST(Sdf, MakesAPlaneASheetUnderTheRestOfTheWorld) {
  const ScratchFolder folder;
  const std::string plane = "<plane><normal>0 0 1</normal></plane>";
  const World world = LoadWorld(folder.Write(
      "w.sdf", InWorld(Model("ground", "0 0 0 0 0 0", plane) + Model("m", "5 0 3 0 0 0", kBox))));
  EXPECT_NEAR(world.bounds_W.sizes().x(), 2 + 20, 1e-4);
  EXPECT_NEAR(world.bounds_W.min().z(), 0, 1e-6);
  EXPECT_TRUE(world.parts.back().half_space);
}

TEST(Sdf, NeverMakesAPlaneLargerThanItsOwnSize) {
  const ScratchFolder folder;
  const std::string plane = "<plane><normal>0 0 1</normal><size>6 8</size></plane>";
  const World world = LoadWorld(folder.Write(
      "w.sdf", InWorld(Model("ground", "0 0 0 0 0 0", plane) + Model("m", "0 0 3 0 0 0", kBox))));
  EXPECT_NEAR(world.bounds_W.sizes().x(), 6, 1e-5);
  EXPECT_NEAR(world.bounds_W.sizes().y(), 8, 1e-5);
}

TEST(Sdf, FindsModelsBesideTheFileAndTheirMeshesAndScalesThem) {
  const ScratchFolder folder;
  folder.Write("models/wedge/model.config",
               "<?xml version='1.0'?><model><name>wedge</name><version>1</version><sdf "
               "version='1.9'>model.sdf</sdf></model>");
  folder.Write("models/wedge/model.sdf",
               "<?xml version='1.0'?><sdf version='1.9'><model name='wedge'><static>true</static><link "
               "name='l'><collision name='s'><geometry>"
               "<mesh><uri>model://wedge/wedge.obj</uri><scale>0.1 0.1 "
               "0.1</scale></mesh></geometry></collision></link></model></sdf>");
  folder.Write("models/wedge/wedge.obj",
               "v 0 0 0\nv 10 0 0\nv 0 20 0\nv 0 0 30\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  const World world = LoadWorld(folder.Write(
      "w.sdf", InWorld("<include><uri>model://wedge</uri><name>a</name><pose>0 0 5 0 0 0</pose></include>")));
  ExpectBox(world.bounds_W, {0, 0, 5}, {1, 2, 8});
}

TEST(Sdf, LooksInTheFoldersOfTheCallerToo) {
  const ScratchFolder folder;
  folder.Write("elsewhere/wedge/wedge.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const std::string path = folder.Write(
      "w.sdf", InWorld(Model("m", "0 0 0 0 0 0", "<mesh><uri>model://wedge/wedge.obj</uri></mesh>")));
  EXPECT_EQ(LoadWorld(path, {(folder.path() / "elsewhere").string()}).mesh.triangles.size(), 1u);
  EXPECT_THAT([&] { LoadWorld(path); }, ThrowsMessage<WorldError>(HasSubstr("wedge.obj is not found")));
}

TEST(Sdf, SaysWhatIsWrongAndWhere) {
  const ScratchFolder folder;
  EXPECT_THAT([&] { LoadWorld((folder.path() / "none.sdf").string()); },
              ThrowsMessage<WorldError>(HasSubstr("there is no such file")));
  EXPECT_THAT([&] { LoadWorld(folder.Write("bad.sdf", "<sdf")); },
              ThrowsMessage<WorldError>(HasSubstr("bad.sdf")));
  EXPECT_THAT([&] { LoadWorld(folder.Write("empty.sdf", InWorld(""))); },
              ThrowsMessage<WorldError>(HasSubstr("there is no surface")));
  EXPECT_THAT(
      [&] { LoadWorld(folder.Write("i.sdf", InWorld("<include><uri>model://nowhere</uri></include>"))); },
      ThrowsMessage<WorldError>(HasSubstr("nowhere")));
}

TEST(Sdf, GivesTheSameHashForTheSameSurfaceAndAnotherForAnother) {
  const ScratchFolder folder;
  const std::string a = folder.Write("a.sdf", InWorld(Model("m", "0 0 0 0 0 0", kBox)));
  const std::string b = folder.Write("b.sdf", InWorld(Model("m", "0 0 0.001 0 0 0", kBox)));
  EXPECT_EQ(LoadWorld(a).hash, LoadWorld(a).hash);
  EXPECT_NE(LoadWorld(a).hash, LoadWorld(b).hash);
}

}  // namespace
}  // namespace citrine::sim

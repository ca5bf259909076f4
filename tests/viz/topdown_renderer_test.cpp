#include "viz/topdown_renderer.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/viz/test_scene.h"
#include "viz/frame_writer.h"
#include "viz/palette.h"

namespace citrine::viz {
namespace {

int CountOf(const Image& image, Colour colour) {
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) count += image.ColourAt(x, y) == colour;
  return count;
}

/// Made once: a map of three million voxels takes its time.
TestScene& Settlement() {
  static TestScene scene;
  return scene;
}

TEST(TopdownRenderer, DrawsTheWholeSceneInTheSameBitsEachTime) {
  const TestScene& test = Settlement();
  const TopdownRenderer renderer(test.volume_W, 24);
  const Image first = renderer.Draw(test.scene);
  EXPECT_EQ(first.width % 2, 0);
  EXPECT_EQ(first.height % 2, 0);
  EXPECT_GE(first.height, 40 * 24);
  EXPECT_EQ(first.bgr, renderer.Draw(test.scene).bgr);
  if (const char* path = std::getenv("CITRINE_TOPDOWN_PNG")) WritePng(path, first);
}

TEST(TopdownRenderer, ShowsEveryUavInItsColour) {
  const TestScene& test = Settlement();
  const TopdownRenderer renderer(test.volume_W, 24);
  for (const SceneUav& uav : test.scene.uavs) {
    Scene alone = test.scene;
    alone.uavs.clear();
    EXPECT_GT(CountOf(renderer.Draw(test.scene), UavColour(uav.id)),
              50 + CountOf(renderer.Draw(alone), UavColour(uav.id)));
  }
}

TEST(TopdownRenderer, FillsAFullHdPictureUnlessAScaleIsAskedFor) {
  Scene empty;
  for (const Eigen::Vector3d& size : {Eigen::Vector3d(14, 14, 8), Eigen::Vector3d(45, 40, 20)}) {
    const Image image = TopdownRenderer({Eigen::Vector3d::Zero(), size}, 0).Draw(empty);
    EXPECT_EQ(image.height, 1080);
    EXPECT_LE(image.width, 1920);
  }
  const Image wide = TopdownRenderer({Eigen::Vector3d::Zero(), Eigen::Vector3d(100, 40, 20)}, 0).Draw(empty);
  EXPECT_LE(wide.width, 1920);
  EXPECT_LE(wide.height, 1080);
}

TEST(TopdownRenderer, ShrinksThePictureToTheRoomThatAScreenHasForIt) {
  const TestScene& test = Settlement();
  const TopdownRenderer renderer(test.volume_W, 0);
  for (const Eigen::Vector2d& room_px :
       {Eigen::Vector2d(1300, 5000), Eigen::Vector2d(5000, 800), Eigen::Vector2d(1300, 800)}) {
    const Image image = renderer.Draw(test.scene, renderer.WholeWithin(room_px));
    EXPECT_LE(image.width, room_px.x() + 2) << "rounded up to an even number";
    EXPECT_LE(image.height, room_px.y() + 2);
    EXPECT_TRUE(image.width > 0.97 * room_px.x() || image.height > 0.97 * room_px.y());
  }
  EXPECT_EQ(renderer.WholeWithin({5000, 5000}).pixels_per_m, renderer.whole().pixels_per_m);
}

TEST(TopdownRenderer, DrawsAPartInAsManyPixelsAsTheWholeAndLeavesOutWhatIsHidden) {
  const TestScene& test = Settlement();
  const TopdownRenderer renderer(test.volume_W, 12);
  const Image whole = renderer.Draw(test.scene);
  View part = renderer.whole();
  part.pixels_per_m *= 2;
  part.area_W = {part.area_W.center() - part.area_W.sizes() / 4,
                 part.area_W.center() + part.area_W.sizes() / 4};
  const Image zoomed = renderer.Draw(test.scene, part);
  EXPECT_EQ(zoomed.width, whole.width);
  EXPECT_EQ(zoomed.height, whole.height);
  EXPECT_NE(zoomed.bgr, whole.bgr);

  View bare = renderer.whole();
  bare.hidden = "hcertpub";
  EXPECT_EQ(renderer.Draw(test.scene, bare).ColourAt(whole.width / 4, whole.height / 2), kUnknown);
  View helped = renderer.whole();
  helped.help = true;
  EXPECT_NE(renderer.Draw(test.scene, helped).bgr, whole.bgr);
}

TEST(TopdownRenderer, DrawsAMissionThatHasNoMapYet) {
  Scene empty;
  empty.mission = "empty";
  const Image image = TopdownRenderer(Settlement().volume_W, 24).Draw(empty);
  EXPECT_EQ(image.ColourAt(image.width / 4, image.height / 2), kUnknown);
}

TEST(TopdownRenderer, FitsLargeFleetsSmallWorldsAndCoarseScales) {
  Scene scene = Settlement().scene;
  while (scene.uavs.size() < 15) {
    scene.uavs.push_back(scene.uavs[scene.uavs.size() % 3]);
    scene.uavs.back().id = static_cast<int>(scene.uavs.size());
  }
  for (const double scale : {2.0, 7.0, 60.0}) {
    const Image image = TopdownRenderer(Settlement().volume_W, scale).Draw(scene);
    EXPECT_GE(image.width, 45 * scale);
    EXPECT_GE(image.height, 720);
  }
}

}  // namespace
}  // namespace citrine::viz

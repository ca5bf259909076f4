#include "viz/view_control.h"

#include <gtest/gtest.h>

#include "viz/layers.h"

namespace citrine::viz {
namespace {

/// 40 m by 20 m at 10 pixels a metre, two UAVs.
class ViewOfAMission : public ::testing::Test {
 protected:
  ViewOfAMission() {
    scene.uavs.resize(2);
    scene.uavs[1].id = 2;
    scene.uavs[1].state.X_WB.p = {5, -3, 2};
  }
  static View Whole() {
    View whole;
    whole.area_W = {Eigen::Vector2d(-20, -10), Eigen::Vector2d(20, 10)};
    whole.pixels_per_m = 10;
    return whole;
  }
  void Press(int key) { control.Handle(WindowEvent::Key(key)); }
  Eigen::Vector2d Centre() { return control.ViewOf(scene).area_W.center(); }

  Scene scene;
  ViewControl control{Whole()};
};

TEST_F(ViewOfAMission, ShowsAllOfItAtFirstAndAgainAfterZero) {
  const auto expect_whole = [&] {
    const View view = control.ViewOf(scene);
    EXPECT_TRUE(view.area_W.isApprox(Whole().area_W));
    EXPECT_EQ(view.pixels_per_m, 10);
  };
  expect_whole();
  for (const int key : std::vector<int>{'+', '+', 'a', '2'}) Press(key);
  EXPECT_FALSE(control.ViewOf(scene).area_W.isApprox(Whole().area_W));
  Press('0');
  expect_whole();
}

TEST_F(ViewOfAMission, HasAsManyPixelsAtEveryZoomAndNeverShowsMoreThanAll) {
  for (int k = 0; k < 60; ++k) {
    Press(k < 30 ? '+' : '-');
    const View view = control.ViewOf(scene);
    EXPECT_NEAR(view.area_W.sizes().x() * view.pixels_per_m, 400, 1e-9);
    EXPECT_NEAR(view.area_W.sizes().y() * view.pixels_per_m, 200, 1e-9);
    EXPECT_GE(view.pixels_per_m, 10 - 1e-9);
    EXPECT_LE(view.pixels_per_m, 400 + 1e-9);
  }
  EXPECT_NEAR(control.ViewOf(scene).pixels_per_m, 10, 1e-9);
}

TEST_F(ViewOfAMission, PansByKeysAndByDraggingTheGroundAlong) {
  Press('d');
  EXPECT_TRUE(Centre().isApprox(Eigen::Vector2d(4, 0)));
  Press('s');
  EXPECT_TRUE(Centre().isApprox(Eigen::Vector2d(4, -2)));
  control.Handle(WindowEvent::Drag({0, 0}, {10, 20}));  // 1 m to the right, 2 m down: what lay there follows
  EXPECT_TRUE(Centre().isApprox(Eigen::Vector2d(3, 0)));
}

TEST_F(ViewOfAMission, CannotBePannedAwayFromTheMission) {
  for (int k = 0; k < 50; ++k) Press('w');
  EXPECT_EQ(Centre().y(), 10);
}

TEST_F(ViewOfAMission, ZoomsInWhereItIsDoubleClicked) {
  control.ViewOf(scene);
  control.Handle(WindowEvent::DoubleClick({300, 50}));  // 10 m east and 5 m north of the middle
  EXPECT_TRUE(Centre().isApprox(Eigen::Vector2d(10, 5)));
  EXPECT_GT(control.ViewOf(scene).pixels_per_m, 10);
}

TEST_F(ViewOfAMission, FollowsAUavUntilItIsAskedToStayOrPanned) {
  Press('2');
  EXPECT_EQ(Centre(), Eigen::Vector2d(5, -3));
  scene.uavs[1].state.X_WB.p.x() = 7;
  EXPECT_EQ(Centre(), Eigen::Vector2d(7, -3));
  Press('2');
  scene.uavs[1].state.X_WB.p.x() = 9;
  EXPECT_EQ(Centre(), Eigen::Vector2d(7, -3)) << "it stays where it was";
  Press('2');
  EXPECT_EQ(Centre(), Eigen::Vector2d(9, -3));
  Press('a');
  EXPECT_EQ(Centre(), Eigen::Vector2d(5, -3)) << "a tenth of 40 m west, and no longer following";
  Press('7');
  EXPECT_EQ(Centre(), Eigen::Vector2d(5, -3)) << "there is no UAV 7";
}

TEST_F(ViewOfAMission, HidesAndShowsEveryLayerByAKeyOfItsOwn) {
  std::string keys;
  for (const Layer& layer : Layers()) {
    if (layer.key == 0) continue;
    EXPECT_EQ(keys.find(layer.key), std::string::npos) << layer.name;
    keys.push_back(layer.key);
    Press(layer.key);
    EXPECT_EQ(control.ViewOf(scene).hidden, std::string(1, layer.key));
    Press(layer.key);
    EXPECT_EQ(control.ViewOf(scene).hidden, "");
  }
  EXPECT_EQ(keys.size(), Layers().size() - 1) << "the strip is always shown";
}

TEST_F(ViewOfAMission, NamesItsKeysWhenAsked) {
  EXPECT_FALSE(control.ViewOf(scene).help);
  Press('?');
  EXPECT_TRUE(control.ViewOf(scene).help);
}

}  // namespace
}  // namespace citrine::viz

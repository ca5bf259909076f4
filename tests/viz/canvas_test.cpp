#include "viz/canvas.h"

#include <gtest/gtest.h>

#include "viz/palette.h"

namespace citrine::viz {
namespace {

constexpr Colour kRed{255, 0, 0};
const Eigen::AlignedBox2d kArea(Eigen::Vector2d(-30, -20), Eigen::Vector2d(30, 20));

Colour At(const Canvas& canvas, const Pixel& p) {
  return canvas.image().ColourAt(static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y())));
}

TEST(Canvas, PutsEastToTheRightAndNorthUp) {
  const Canvas canvas(kArea, 20);
  EXPECT_NEAR((canvas.ToPixel(Eigen::Vector2d(-30, 20)) - Pixel(-0.5, -0.5)).norm(), 0, 1e-9);
  EXPECT_NEAR((canvas.ToPixel(Eigen::Vector2d(30, -20)) - Pixel(1199.5, 799.5)).norm(), 0, 1e-9);
  EXPECT_EQ(canvas.map_px().sizes().x(), 1200);
  EXPECT_EQ(canvas.image().height, 800);
}

TEST(Canvas, StandsASmallAreaInTheMiddle) {
  const Canvas canvas({Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1)}, 20);
  EXPECT_EQ(canvas.image().height, 720);
  EXPECT_NEAR(canvas.ToPixel(Eigen::Vector2d(0, 0)).y(), 359.5, 1e-9);
}

TEST(Canvas, DrawsADiscWhereItIsAndNowhereElse) {
  Canvas canvas(kArea, 20);
  const Pixel centre = canvas.ToPixel(Eigen::Vector2d(5, 7));
  canvas.Disc(centre, 10, kRed);
  EXPECT_EQ(At(canvas, centre), kRed);
  EXPECT_EQ(At(canvas, centre + Pixel(8, 0)), kRed);
  EXPECT_EQ(At(canvas, centre + Pixel(13, 0)), kUnknown);
}

TEST(Canvas, MixesWhatIsHalfOpaque) {
  Canvas canvas(kArea, 20);
  canvas.Fill({Pixel(100, 100), Pixel(200, 200)}, kRed, 0.5);
  EXPECT_NEAR(At(canvas, {150, 150}).r, (255 + kUnknown.r) / 2, 1);
  EXPECT_EQ(At(canvas, {250, 150}), kUnknown);
}

TEST(Canvas, LaysCellsOverTheGroundTheyCover) {
  Canvas canvas(kArea, 20);
  Image cells(2, 2, kRed);
  cells.Set(1, 0, {0, 255, 0});  // north-east
  canvas.Lay(cells, {1, 1, 1, 0}, {10, 0}, 4.0);
  EXPECT_EQ(At(canvas, canvas.ToPixel(Eigen::Vector2d(12, 6))), kRed);
  EXPECT_EQ(At(canvas, canvas.ToPixel(Eigen::Vector2d(16, 6))), (Colour{0, 255, 0}));
  EXPECT_EQ(At(canvas, canvas.ToPixel(Eigen::Vector2d(16, 2))), kUnknown);
  EXPECT_EQ(At(canvas, canvas.ToPixel(Eigen::Vector2d(5, 6))), kUnknown);
}

TEST(Canvas, CutsOffWhatLiesOutside) {
  Canvas canvas(kArea, 20);
  canvas.Disc({-1e9, 5}, 10, kRed, 0.5);
  canvas.Disc({-3, 5}, 10, kRed, 0.5);
  canvas.Polyline({{-1e5, -1e5}, {1e5, 1e5}}, kRed, 2, 0.5);
  canvas.Text({-50, 1e4}, "far", kRed, 12);
  EXPECT_NE(At(canvas, {2, 5}), kUnknown);
}

}  // namespace
}  // namespace citrine::viz

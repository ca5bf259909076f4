#include "viz/palette.h"

#include <cmath>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

namespace citrine::viz {
namespace {

/// CIE L* of an sRGB colour.
double Lightness(Colour colour) {
  const auto linear = [](std::uint8_t x) {
    const double u = x / 255.0;
    return u <= 0.04045 ? u / 12.92 : std::pow((u + 0.055) / 1.055, 2.4);
  };
  const double Y = 0.2126 * linear(colour.r) + 0.7152 * linear(colour.g) + 0.0722 * linear(colour.b);
  return Y > 0.008856 ? 116 * std::cbrt(Y) - 16 : 903.3 * Y;
}

TEST(ShareColour, GetsEvenlyLighterSoThatItReadsInGrey) {
  double before = Lightness(ShareColour(0));
  const double step = (Lightness(ShareColour(1)) - before) / 10;
  EXPECT_GT(step, 6);
  for (int k = 1; k <= 10; ++k) {
    const double now = Lightness(ShareColour(k / 10.0));
    EXPECT_NEAR(now - before, step, 0.5 * step) << "at " << k / 10.0;
    before = now;
  }
}

TEST(ShareColour, ClampsItsShare) {
  EXPECT_EQ(ShareColour(-1), ShareColour(0));
  EXPECT_EQ(ShareColour(2), ShareColour(1));
}

TEST(UavColour, TellsSevenUavsApart) {
  std::set<std::tuple<int, int, int>> colours;
  for (int uav = 1; uav <= 7; ++uav) colours.insert({UavColour(uav).r, UavColour(uav).g, UavColour(uav).b});
  EXPECT_EQ(colours.size(), 7u);
  EXPECT_EQ(UavColour(8), UavColour(1));
}

}  // namespace
}  // namespace citrine::viz

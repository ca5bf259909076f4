#include "viz/layers/strip_parts.h"
#include "viz/palette.h"

namespace citrine::viz {

namespace {

void DrawColourBar(const Scene& scene, Canvas& canvas, StripCursor& cursor) {
  const double s = cursor.s;
  cursor.y += 14 * s;
  constexpr int kSteps = 96;
  for (int k = 0; k < kSteps; ++k) {
    const Pixel corner(cursor.left + cursor.width() * k / kSteps, cursor.y);
    canvas.Fill({corner, corner + Pixel(cursor.width() / kSteps, 12 * s)}, ShareColour((k + 0.5) / kSteps));
  }
  cursor.y += 30 * s;
  canvas.Text({cursor.left, cursor.y}, "confidence 0", kText, 10.5 * s);
  canvas.Text({cursor.right, cursor.y}, Format("w* (d* = %.1f m)", scene.goals.whole().d_star_m), kText,
              10.5 * s, Canvas::Align::kRight);
}

template <class Mark>
void DrawEntry(const std::string& text, Canvas& canvas, StripCursor& cursor, double column,
               const Mark& mark) {
  const double s = cursor.s;
  const Pixel at(cursor.left + column * cursor.width(), cursor.y);
  mark(Pixel(at + Pixel(10 * s, -4.5 * s)));
  canvas.Text(at + Pixel(28 * s, 0), text, kText, 10.5 * s);
}

}  // namespace

/// What colours and marks mean; left out where the strip has no room for it.
void DrawLegendPart(const Scene& scene, Canvas& canvas, StripCursor& cursor) {
  const double s = cursor.s;
  const double height = 218 * s;
  if (cursor.y + height > canvas.strip_px().max().y()) return;
  cursor.y = canvas.strip_px().max().y() - height;
  DrawHeading("LEGEND", canvas, cursor);
  DrawColourBar(scene, canvas, cursor);
  cursor.y += 26 * s;
  DrawEntry("incomplete", canvas, cursor, 0, [&](const Pixel& at) { canvas.Disc(at, 3 * s, kIncomplete); });
  DrawEntry("low quality", canvas, cursor, 0.5,
            [&](const Pixel& at) { canvas.Disc(at, 3 * s, kLowQuality); });
  cursor.y += 23 * s;
  DrawEntry("next view", canvas, cursor, 0,
            [&](const Pixel& at) { DrawTarget(at, 7 * s, UavColour(1), canvas); });
  DrawEntry("trajectory", canvas, cursor, 0.5, [&](const Pixel& at) {
    canvas.Polyline({at - Pixel(10 * s, 0), at + Pixel(10 * s, 0)}, kText, 3 * s);
  });
  cursor.y += 23 * s;
  DrawEntry("share of the load", canvas, cursor, 0,
            [&](const Pixel& at) { DrawDiamond(at, 7 * s, UavColour(1), canvas); });
  DrawEntry("path searched", canvas, cursor, 0.5, [&](const Pixel& at) {
    canvas.Dashes({at - Pixel(10 * s, 0), at + Pixel(10 * s, 0)}, UavColour(1), 2 * s, 4 * s);
  });
  cursor.y += 23 * s;
  const auto swatch = [&](Colour colour) {
    return [&canvas, s, colour](const Pixel& at) {
      canvas.Fill({at - Pixel(8 * s, 6 * s), at + Pixel(8 * s, 6 * s)}, colour);
      canvas.Outline({at - Pixel(8 * s, 6 * s), at + Pixel(8 * s, 6 * s)}, kRule, s);
    };
  };
  DrawEntry("never seen", canvas, cursor, 0, swatch(kUnknown));
  DrawEntry("seen, no surface", canvas, cursor, 0.5, swatch(kKnownFree));
}

}  // namespace citrine::viz

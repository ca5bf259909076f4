#pragma once

#include <string>

#include "viz/canvas.h"
#include "viz/relief.h"
#include "viz/scene.h"

namespace citrine::viz {

/// Where the strip's next line goes; parts move it down by what they have drawn.
struct StripCursor {
  double left = 0, right = 0, y = 0, s = 1;
  double width() const { return right - left; }
};

/// A small heading with a rule above it.
void DrawHeading(const std::string& text, Canvas& canvas, StripCursor& cursor);
/// A line with a name on the left and a value on the right.
void DrawValue(const std::string& name, const std::string& value, Canvas& canvas, StripCursor& cursor);

/// What a UAV is given by a correction of the fleet's balance: its centroid.
void DrawDiamond(const Pixel& at, double radius_px, Colour colour, Canvas& canvas);
/// The next view of a UAV.
void DrawTarget(const Pixel& at, double radius_px, Colour colour, Canvas& canvas);

void DrawFleetPart(const Scene& scene, Canvas& canvas, StripCursor& cursor);
void DrawLegendPart(const Scene& scene, Canvas& canvas, StripCursor& cursor);

/// printf into a string.
std::string Format(const char* format, ...) __attribute__((format(printf, 1, 2)));

}  // namespace citrine::viz

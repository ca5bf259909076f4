#include <cmath>
#include <string>

#include "viz/layers.h"
#include "viz/palette.h"

namespace citrine::viz {

/// A bar of 1, 2 or 5 times a power of ten metres, about a sixth of the map wide.
void DrawScaleBar(const Scene&, const Relief&, Canvas& canvas) {
  const double s = canvas.scale();
  const Eigen::AlignedBox2d map = canvas.map_px();
  const double wanted_m = map.sizes().x() / 6 / canvas.pixels_per_m();
  double length_m = std::pow(10, std::floor(std::log10(wanted_m)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * length_m <= wanted_m) {
      length_m *= factor;
      break;
    }
  }
  const double length_px = length_m * canvas.pixels_per_m();
  const Pixel left(28 * s, map.max().y() - 28 * s);
  canvas.Fill({left + Pixel(-14 * s, -32 * s), left + Pixel(length_px + 14 * s, 14 * s)}, kUnknown, 0.75);
  const Pixel right = left + Pixel(length_px, 0);
  canvas.Polyline({left + Pixel(0, -6 * s), left, right, right + Pixel(0, -6 * s)}, kText, 2 * s);
  char label[32];
  std::snprintf(label, sizeof label, "%g m", length_m);
  canvas.Text((left + right) / 2 + Pixel(0, -10 * s), label, kText, 12 * s, Canvas::Align::kCentre);
}

}  // namespace citrine::viz

#include "viz/layers.h"
#include "viz/palette.h"

namespace citrine::viz {

/// A dot for each active surface element.
void DrawActiveElements(const Scene& scene, const Relief&, Canvas& canvas) {
  const double radius_px = std::max(1.0, 0.065 * canvas.pixels_per_m());
  for (const Eigen::Vector3f& p_W : scene.low_quality_W) {
    canvas.Disc(canvas.ToPixel(Eigen::Vector3d(p_W.cast<double>())), radius_px, kLowQuality, 0.75);
  }
  for (const Eigen::Vector3f& p_W : scene.incomplete_W) {
    canvas.Disc(canvas.ToPixel(Eigen::Vector3d(p_W.cast<double>())), radius_px, kIncomplete, 0.8);
  }
}

}  // namespace citrine::viz

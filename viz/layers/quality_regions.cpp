#include <cstdio>

#include "viz/layers.h"
#include "viz/palette.h"

namespace citrine::viz {

/// Regions with a goal of their own, each with its d*.
void DrawQualityRegions(const Scene& scene, const Relief&, Canvas& canvas) {
  for (const QualityGoals::Region& region : scene.goals.regions()) {
    const Pixel a = canvas.ToPixel(region.box_W.min());
    const Pixel b = canvas.ToPixel(region.box_W.max());
    const Eigen::AlignedBox2d box(a.cwiseMin(b), a.cwiseMax(b));
    const std::vector<Pixel> around{
        box.min(), {box.max().x(), box.min().y()}, box.max(), {box.min().x(), box.max().y()}, box.min()};
    const double s = canvas.scale();
    canvas.Polyline(around, kOutline, 4 * s, 0.6);
    canvas.Dashes(around, kText, 2 * s, 9 * s);
    char label[32];
    std::snprintf(label, sizeof label, "d* %.1f m", region.goal.d_star_m);
    canvas.Fill({box.min() + Pixel(0, -22 * s), box.min() + Pixel(92 * s, -4 * s)}, kOutline, 0.7);
    canvas.Text(box.min() + Pixel(6 * s, -8 * s), label, kText, 11 * s);
  }
}

}  // namespace citrine::viz

#include <algorithm>
#include <cstdarg>
#include <cstdio>

#include "viz/layers.h"
#include "viz/layers/strip_parts.h"
#include "viz/palette.h"

namespace citrine::viz {

std::string Format(const char* format, ...) {
  char text[160];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  return text;
}

void DrawHeading(const std::string& text, Canvas& canvas, StripCursor& cursor) {
  cursor.y += 18 * cursor.s;
  canvas.Polyline({{cursor.left, cursor.y}, {cursor.right, cursor.y}}, kRule, cursor.s);
  cursor.y += 26 * cursor.s;
  canvas.Text({cursor.left, cursor.y}, text, kTextDim, 10.5 * cursor.s);
  cursor.y += 8 * cursor.s;
}

void DrawValue(const std::string& name, const std::string& value, Canvas& canvas, StripCursor& cursor) {
  cursor.y += 23 * cursor.s;
  canvas.Text({cursor.left, cursor.y}, name, kText, 11.5 * cursor.s);
  canvas.Text({cursor.right, cursor.y}, value, kText, 11.5 * cursor.s, Canvas::Align::kRight);
}

namespace {

double ReachedShare(const MissionProgress& progress) {
  return progress.surface_voxels > 0 ? static_cast<double>(progress.voxels_at_goal) / progress.surface_voxels
                                     : 0.0;
}

void DrawTitle(const Scene& scene, Canvas& canvas, StripCursor& cursor) {
  const double s = cursor.s;
  cursor.y += 46 * s;
  canvas.Text({cursor.left, cursor.y}, scene.mission, kText, 20 * s, Canvas::Align::kLeft, true);
  const auto seconds = static_cast<int>(Seconds(scene.now));
  canvas.Text({cursor.right, cursor.y}, Format("%d:%02d", seconds / 60, seconds % 60), kText, 20 * s,
              Canvas::Align::kRight);
  cursor.y += 26 * s;
  canvas.Text({cursor.left, cursor.y}, scene.strategy, kTextDim, 11.5 * s);
}

/// The share that reached its goal: number, bar, and how it grew.
void DrawReached(const Scene& scene, Canvas& canvas, StripCursor& cursor) {
  const double s = cursor.s;
  const double share = ReachedShare(scene.progress);
  cursor.y += 62 * s;
  canvas.Text({cursor.left, cursor.y}, Format("%.1f %%", 100 * share), kText, 24 * s, Canvas::Align::kLeft,
              true);
  canvas.Text({cursor.right, cursor.y}, "of the surface at w*", kTextDim, 10.5 * s, Canvas::Align::kRight);
  cursor.y += 14 * s;
  const Pixel corner(cursor.left, cursor.y);
  canvas.Fill({corner, corner + Pixel(cursor.width(), 7 * s)}, kRule);
  if (share > 0) canvas.Fill({corner, corner + Pixel(cursor.width() * share, 7 * s)}, ShareColour(0.85));
  cursor.y += 18 * s;

  const double height = 74 * s;
  const Eigen::AlignedBox2d chart(Pixel(cursor.left, cursor.y), Pixel(cursor.right, cursor.y + height));
  canvas.Fill(chart, kUnknown);
  std::vector<Pixel> line;
  const double end_s = std::max(Seconds(scene.now), 1.0);
  for (const Scene::Reached& point : scene.history) {
    line.push_back({chart.min().x() + chart.sizes().x() * std::min(point.time_s / end_s, 1.0),
                    chart.max().y() - 2 * s - (height - 5 * s) * point.share});
  }
  canvas.Polyline(line, ShareColour(0.85), 2 * s);
  cursor.y += height + 4 * s;
}

}  // namespace

void DrawStrip(const Scene& scene, const Relief&, Canvas& canvas) {
  const Eigen::AlignedBox2d strip = canvas.strip_px();
  canvas.Fill(strip, kStrip);
  const double s = canvas.scale();
  StripCursor cursor{strip.min().x() + 26 * s, strip.max().x() - 26 * s, strip.min().y(), s};
  DrawTitle(scene, canvas, cursor);
  DrawReached(scene, canvas, cursor);

  const MissionProgress& progress = scene.progress;
  DrawValue("surface voxels", Format("%d", progress.surface_voxels), canvas, cursor);
  DrawValue("incomplete elements", Format("%d", progress.elements_ise), canvas, cursor);
  DrawValue("low-quality elements", Format("%d", progress.elements_lqse), canvas, cursor);
  DrawValue("quality, of its goal",
            progress.z_goal > 0 ? Format("%.1f %%", 100 * progress.z_bar_sat / progress.z_goal) : "-", canvas,
            cursor);
  DrawValue("volume known", Format("%.1f %%", progress.known_pct), canvas, cursor);
  DrawFleetPart(scene, canvas, cursor);
  DrawLegendPart(scene, canvas, cursor);
}

}  // namespace citrine::viz

#include <cmath>

#include "core/vehicle/airframe.h"
#include "viz/layers.h"
#include "viz/layers/strip_parts.h"
#include "viz/palette.h"

namespace citrine::viz {

namespace {

/// Committed trajectory from now to its end.
std::vector<Pixel> RemainingWay(const Trajectory& trajectory, Utime now, const Canvas& canvas) {
  std::vector<Pixel> way;
  constexpr Utime kSpacing = 50'000;
  for (Utime t = std::max(now, trajectory.start); t < trajectory.end(); t += kSpacing) {
    way.push_back(canvas.ToPixel(trajectory.At(t).p_W));
  }
  if (!way.empty()) way.push_back(canvas.ToPixel(trajectory.At(trajectory.end()).p_W));
  return way;
}

void DrawAirframe(const SceneUav& uav, double radius_m, Canvas& canvas) {
  const double s = canvas.scale();
  const Colour colour = UavColour(uav.id);
  const Pixel at = canvas.ToPixel(uav.state.X_WB.p);
  canvas.Disc(at, radius_m * canvas.pixels_per_m(), colour, 0.18);
  canvas.Ring(at, radius_m * canvas.pixels_per_m(), colour, 1.5 * s, 0.9);

  const double yaw = YawOf(uav.state.X_WB.q);
  const double size_px = std::max(1.15 * kAirframeRadius_m * canvas.pixels_per_m(), 7 * s);
  const auto arm = [&](double angle) { return Pixel(std::cos(yaw + angle), -std::sin(yaw + angle)); };
  for (const auto& [ink, grow] : {std::pair{kOutline, 2.0 * s}, std::pair{colour, 0.0}}) {
    for (int k = 0; k < 4; ++k) {
      const Pixel rotor = at + size_px * arm(EIGEN_PI / 4 + k * EIGEN_PI / 2);
      canvas.Polyline({at, rotor}, ink, 3 * s + 2 * grow);
      canvas.Disc(rotor, 0.52 * size_px + grow, ink);
    }
    canvas.Polyline({at, at + 1.25 * size_px * arm(0)}, ink, 3 * s + 2 * grow);
    canvas.Disc(at, 0.42 * size_px + grow, ink);
  }
  const double beside_px = radius_m * canvas.pixels_per_m() + 6 * s;
  const bool room_above = at.y() - beside_px - 18 * s > 0;
  const Pixel label = at + Pixel(0, room_above ? -beside_px : beside_px + 16 * s);
  const std::string name = std::to_string(uav.id);
  canvas.Fill({label + Pixel(-9 * s, -18 * s), label + Pixel(9 * s, 3 * s)}, kOutline, 0.75);
  canvas.Text(label + Pixel(0, -1.5 * s), name, colour, 13 * s, Canvas::Align::kCentre);
}

}  // namespace

void DrawDiamond(const Pixel& at, double radius_px, Colour colour, Canvas& canvas) {
  const double s = canvas.scale();
  const std::vector<Pixel> round{at + Pixel(radius_px, 0), at + Pixel(0, -radius_px),
                                 at - Pixel(radius_px, 0), at + Pixel(0, radius_px),
                                 at + Pixel(radius_px, 0)};
  canvas.Polyline(round, kOutline, 4.5 * s);
  canvas.Polyline(round, colour, 2.5 * s);
}

void DrawTarget(const Pixel& at, double radius_px, Colour colour, Canvas& canvas) {
  const double s = canvas.scale();
  for (const auto& [ink, grow] : {std::pair{kOutline, 1.0 * s}, std::pair{colour, 0.0}}) {
    canvas.Ring(at, radius_px, ink, 2.5 * s + 2 * grow);
    canvas.Disc(at, 0.3 * radius_px + grow, ink);
  }
}

void DrawTrails(const Scene& scene, const Relief&, Canvas& canvas) {
  const double s = canvas.scale();
  for (const SceneUav& uav : scene.uavs) {
    const std::vector<Pixel> trail = canvas.ToPixels(uav.trail_W);
    canvas.Polyline(trail, kOutline, 4 * s, 0.45);
    canvas.Polyline(trail, UavColour(uav.id), 2 * s, 0.85);
  }
}

void DrawPlans(const Scene& scene, const Relief&, Canvas& canvas) {
  const double s = canvas.scale();
  for (const SceneUav& uav : scene.uavs) {
    const Colour colour = UavColour(uav.id);
    if (uav.path && uav.status && uav.status->has_goal) {
      std::vector<Pixel> way;
      for (const Waypoint& waypoint : uav.path->waypoints) way.push_back(canvas.ToPixel(waypoint.p_W));
      canvas.Dashes(way, colour, 1.5 * s, 5 * s);
    }
    if (uav.trajectory) {
      const std::vector<Pixel> way = RemainingWay(*uav.trajectory, scene.now, canvas);
      canvas.Polyline(way, kOutline, 6 * s, 0.7);
      canvas.Polyline(way, kText, 3 * s);
    }
    if (uav.centroid_W) DrawDiamond(canvas.ToPixel(*uav.centroid_W), 12 * s, colour, canvas);
    if (uav.status && uav.status->has_goal)
      DrawTarget(canvas.ToPixel(uav.status->goal_W), 11 * s, colour, canvas);
  }
}

void DrawUavs(const Scene& scene, const Relief&, Canvas& canvas) {
  for (const SceneUav& uav : scene.uavs) DrawAirframe(uav, scene.uav_radius_m, canvas);
}

}  // namespace citrine::viz

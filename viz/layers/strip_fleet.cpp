#include "viz/layers/strip_parts.h"
#include "viz/palette.h"

namespace citrine::viz {

namespace {

constexpr std::size_t kRowsMax = 8;

std::string ActivityOf(const SceneUav& uav) {
  if (!uav.status) return "";
  if (uav.status->no_view_left) return "done";
  if (uav.status->replanning) return "balancing";
  switch (uav.status->activity) {
    case FleetStatus::Activity::kDeciding:
      return "deciding";
    case FleetStatus::Activity::kFlying:
      return "flying";
    case FleetStatus::Activity::kIdle:
      return "idle";
  }
  return "";
}

}  // namespace

/// A row a UAV: what it does, speed, height, metres flown, and collisions where there were any.
void DrawFleetPart(const Scene& scene, Canvas& canvas, StripCursor& cursor) {
  const double s = cursor.s;
  DrawHeading("FLEET", canvas, cursor);
  const auto column = [&](double share) { return cursor.left + share * cursor.width(); };
  for (std::size_t i = 0; i < scene.uavs.size() && i < kRowsMax; ++i) {
    const SceneUav& uav = scene.uavs[i];
    cursor.y += 28 * s;
    const double size = 11.5 * s;
    canvas.Disc({cursor.left + 9 * s, cursor.y - 5 * s}, 10 * s, UavColour(uav.id));
    canvas.Text({cursor.left + 9 * s, cursor.y - 0.5 * s}, std::to_string(uav.id), kOutline, 10 * s,
                Canvas::Align::kCentre);
    const bool collided = uav.state.contacts > 0;
    canvas.Text({cursor.left + 30 * s, cursor.y},
                collided ? Format("%d hit", uav.state.contacts) : ActivityOf(uav),
                collided ? UavColour(5) : kTextDim, size);
    canvas.Text({column(0.57), cursor.y}, Format("%.1f m/s", uav.state.v_W.norm()), kText, size,
                Canvas::Align::kRight);
    canvas.Text({column(0.78), cursor.y}, Format("z %.1f", uav.state.X_WB.p.z()), kTextDim, size,
                Canvas::Align::kRight);
    canvas.Text({cursor.right, cursor.y}, Format("%.0f m", uav.flown_m), kText, size, Canvas::Align::kRight);
  }
  if (scene.uavs.size() > kRowsMax) {
    cursor.y += 23 * s;
    canvas.Text({cursor.left, cursor.y}, Format("and %zu more", scene.uavs.size() - kRowsMax), kTextDim,
                11 * s);
  }
}

}  // namespace citrine::viz

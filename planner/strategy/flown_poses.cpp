#include "planner/strategy/flown_poses.h"

#include "planner/view/well_seen.h"

namespace citrine::planner {

namespace {
constexpr double kApart_m = 0.5;
}  // namespace

void FlownPoses::Add(int uav, const Pose& X_WB, Utime now) {
  if (uav < 1 || uav > static_cast<int>(last_W_.size())) return;
  Eigen::Vector3d& last_W = last_W_[static_cast<std::size_t>(uav - 1)];
  if ((X_WB.p - last_W).norm() < kApart_m) return;
  last_W = X_WB.p;
  flown_.push_back({X_WB, now});
}

int FlownPoses::Looks(const PlanningMap& map, const Element& element, const SensorWindow& window,
                      Utime before, int enough) const {
  int looks = 0;
  for (const Flown& flown : flown_) {
    if (flown.at >= before || looks == enough) break;
    const Eigen::Vector3d to = element.p_W - flown.X_WB.p;
    if (to.squaredNorm() > element.d_star_m * element.d_star_m) continue;
    if (!window.InFieldOfView(flown.X_WB.q.conjugate() * to)) continue;
    looks += WellSeen(map, element, window, flown.X_WB.p);
  }
  return looks;
}

}  // namespace citrine::planner

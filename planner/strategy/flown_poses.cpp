#include "planner/strategy/flown_poses.h"

#include "planner/view/well_seen.h"

namespace citrine::planner {

namespace {
constexpr double kApart_m = 0.5;
constexpr std::size_t kStretch = 8;
constexpr double kRounding = 1e-9;  ///< by which a squared distance to a box may be too large
}  // namespace

FlownPoses::FlownPoses(int uavs)
    : last_W_(static_cast<std::size_t>(uavs), Eigen::Vector3d::Constant(1e9)),
      newest_(last_W_.size()),
      stretches_(last_W_.size()) {
  for (std::size_t i = 0; i < newest_.size(); ++i) newest_[i] = i;
}

void FlownPoses::Add(int uav, const Pose& X_WB, Utime now) {
  if (uav < 1 || uav > static_cast<int>(last_W_.size())) return;
  Eigen::Vector3d& last_W = last_W_[static_cast<std::size_t>(uav - 1)];
  if ((X_WB.p - last_W).norm() < kApart_m) return;
  last_W = X_WB.p;
  std::size_t& newest = newest_[static_cast<std::size_t>(uav - 1)];
  if (stretches_[newest].flown.size() == kStretch) {
    newest = stretches_.size();
    stretches_.emplace_back();
  }
  stretches_[newest].around_W.extend(X_WB.p);
  stretches_[newest].flown.push_back({X_WB, now});
}

int FlownPoses::Looks(const PlanningMap& map, const Element& element, const SensorWindow& window,
                      Utime before, int enough) const {
  int looks = 0;
  const double reach_sq = element.d_star_m * element.d_star_m;
  for (const Stretch& stretch : stretches_) {
    if (stretch.around_W.squaredExteriorDistance(element.p_W) > (1 + kRounding) * reach_sq) continue;
    for (const Flown& flown : stretch.flown) {
      if (flown.at >= before) break;
      if (looks == enough) return looks;
      const Eigen::Vector3d to = element.p_W - flown.X_WB.p;
      if (to.squaredNorm() > reach_sq) continue;
      if (!window.InFieldOfView(flown.X_WB.q.conjugate() * to)) continue;
      looks += WellSeen(map, element, window, flown.X_WB.p);
    }
  }
  return looks;
}

}  // namespace citrine::planner

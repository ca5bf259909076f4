#include "planner/trajectory/whereabouts.h"

#include <algorithm>

namespace citrine::planner {

namespace {

constexpr Utime kBox = 500'000, kSample = 50'000;
constexpr double kBetween_m = 0.01;  ///< off the chord between two samples: a t^2 / 8 = 1.5 mm at 4.8 m/s^2

}  // namespace

Whereabouts::Whereabouts(const Trajectory& trajectory, Utime from) {
  const Utime end = std::max(from, trajectory.end());
  for (Utime begin = from; boxes_W_.empty() || begin < end + kBox; begin += kBox) {
    Eigen::AlignedBox3d box_W;
    for (Utime t = begin; t <= begin + kBox; t += kSample) box_W.extend(trajectory.At(t).p_W);
    const Eigen::Vector3d room = Eigen::Vector3d::Constant(kBetween_m);
    boxes_W_.emplace_back(box_W.min() - room, box_W.max() + room);
  }
}

bool Whereabouts::MayBeNear(const Eigen::Vector3d& p_W, double t_s, double distance_m) const {
  const auto box = static_cast<std::size_t>(std::max(0.0, t_s / Seconds(kBox)));
  return boxes_W_[std::min(box, boxes_W_.size() - 1)].squaredExteriorDistance(p_W) < distance_m * distance_m;
}

}  // namespace citrine::planner

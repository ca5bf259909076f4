#include "planner/safety/collision_guard.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "planner/trajectory/brake.h"

namespace citrine::planner {

namespace {

constexpr double kReaction_s = 0.25;  ///< the guard's period, a step, and what lies ahead of a new trajectory
constexpr double kHorizonSpare_s = 0.5;
constexpr double kImminent_s = 0.6;  ///< before stopping takes as long as there is
constexpr Utime kSample = 50'000;
constexpr Utime kStale = 500'000;  ///< an older scan says nothing about now
// The map's distances are those of voxel centres: a committed way may pass that much nearer to the very
// surface.
constexpr double kMapError_m = 0.2;
constexpr double kNearing_m = 0.05;
constexpr double kMoving_mps = 0.1;
constexpr float kSlack_m = 0.01f;  ///< far above the rounding of floats
constexpr double kTeammateSize_m =
    0.3;  ///< hits this far beyond the radius around a teammate are the teammate

}  // namespace

double CollisionGuard::BoxLength(double speed_mps) const {
  return limits_.radius_m + speed_mps * kReaction_s + StoppingDistance(speed_mps, limits_);
}

void CollisionGuard::HearScan(LidarScan scan) {
  if (!scan_ || !(scan.model == scan_->model)) {
    directions_S_ = {};
    for (int row = 0; row < scan.model.rows; ++row)
      for (int col = 0; col < scan.model.cols; ++col)
        for (int axis = 0; axis < 3; ++axis)
          directions_S_[axis].push_back(static_cast<float>(scan.model.Direction(row, col)[axis]));
  }
  scan_ = std::move(scan);
}

std::vector<std::size_t> CollisionGuard::BeamsInto(const Box& box) const {
  const Pose X_SW = scan_->X_WS.Inverse();
  const Eigen::Vector3f from = (X_SW * box.from_W).cast<float>(),
                        ahead = (X_SW.q * box.ahead_W).cast<float>();
  const auto reach = static_cast<float>(BoxLength(limits_.speed_max_mps) + limits_.radius_m);
  const auto length = static_cast<float>(box.length_m), radius = static_cast<float>(box.radius_m) + kSlack_m;
  std::vector<std::uint8_t> into(scan_->ranges_m.size());
  for (std::size_t i = 0; i < into.size(); ++i) {
    const float range = scan_->ranges_m[i];
    const float x = range * directions_S_[0][i] - from.x(), y = range * directions_S_[1][i] - from.y(),
                z = range * directions_S_[2][i] - from.z();
    const float along = x * ahead.x() + y * ahead.y() + z * ahead.z();
    const float beside_sq = x * x + y * y + z * z - along * along;
    into[i] = (range > 0) & (range < reach) & (along > -kSlack_m) & (along < length + kSlack_m) &
              (beside_sq < radius * radius);
  }
  std::vector<std::size_t> beams;
  for (auto at = into.begin(); (at = std::find(at, into.end(), 1)) != into.end(); ++at)
    beams.push_back(static_cast<std::size_t>(at - into.begin()));
  return beams;
}

std::vector<Eigen::Vector3d> CollisionGuard::HitsIn(const Box& box) const {
  const Eigen::Matrix3d R_WS = scan_->X_WS.q.toRotationMatrix();
  std::vector<Eigen::Vector3d> hits_W;
  for (const std::size_t i : BeamsInto(box)) {
    const Eigen::Vector3f direction_S(directions_S_[0][i], directions_S_[1][i], directions_S_[2][i]);
    const Eigen::Vector3d hit_W = R_WS * (scan_->ranges_m[i] * direction_S).cast<double>() + scan_->X_WS.p;
    const Eigen::Vector3d offset = hit_W - box.from_W;
    const double along = offset.dot(box.ahead_W);
    if (along >= 0 && along <= box.length_m && (offset - along * box.ahead_W).norm() <= box.radius_m)
      hits_W.push_back(hit_W);
  }
  return hits_W;
}

std::optional<Utime> CollisionGuard::FindHit(const Trajectory& committed, Utime now, const FlightScene& scene,
                                             double horizon_s) const {
  if (!scan_ || now - scan_->measured > kStale) return std::nullopt;
  const TrajectoryPoint here = committed.At(now);
  horizon_s = std::max(horizon_s, here.v_W.norm() / limits_.acceleration_max_mps2 + kHorizonSpare_s);
  std::vector<Eigen::Vector3d> way_W;
  double speed = 0;
  for (Utime t = now; t < now + FromSeconds(horizon_s); t += kSample) {
    const TrajectoryPoint x = committed.At(t);
    way_W.push_back(x.p_W);
    speed = std::max(speed, x.v_W.norm());
  }
  const bool moves = here.v_W.norm() > kMoving_mps;
  const Eigen::Vector3d travel = moves ? here.v_W : Eigen::Vector3d(way_W.back() - way_W.front());
  if (speed < kMoving_mps || travel.norm() < kNearing_m) return std::nullopt;

  std::optional<Utime> first;
  for (const Eigen::Vector3d& hit_W :
       HitsIn({here.p_W, travel.normalized(), BoxLength(speed), limits_.radius_m})) {
    const bool is_teammate =
        std::any_of(scene.teammates.begin(), scene.teammates.end(), [&](const Teammate& other) {
          return (other.trajectory.At(scan_->measured).p_W - hit_W).norm() <
                 limits_.radius_m + kTeammateSize_m;
        });
    if (is_teammate) continue;
    const double asked = std::min(limits_.radius_m - kMapError_m, (hit_W - here.p_W).norm() - kNearing_m);
    for (std::size_t k = 0; k < way_W.size(); ++k) {
      if ((way_W[k] - hit_W).norm() >= asked) continue;
      const Utime at = now + static_cast<Utime>(k) * kSample;
      first = first ? std::min(*first, at) : at;
      break;
    }
  }
  return first;
}

std::optional<Violation> CollisionGuard::FindConflictToSolve(const Trajectory& committed, Utime now,
                                                             const FlightScene& scene) const {
  if (committed.end() <= now) return std::nullopt;  // it stands still: whoever moves avoids it
  const double stopping_s = committed.At(now).v_W.norm() / limits_.acceleration_max_mps2 + kReaction_s;
  for (const Teammate& teammate : scene.teammates) {
    const std::optional<Violation> conflict = FindConflict(committed, now, teammate, scene.separation_m());
    if (!conflict) continue;
    const bool it_cannot = teammate.trajectory.end() <= now;
    const bool imminent = Seconds(conflict->at - now) < stopping_s + kImminent_s;
    if (it_cannot || teammate.uav < uav_ || imminent) return conflict;
  }
  return std::nullopt;
}

GuardVerdict CollisionGuard::Check(const Trajectory& committed, Utime now, const FlightScene& scene) const {
  if (const std::optional<Utime> at = FindHit(committed, now, scene))
    return {GuardVerdict::Action::kBrake, *at, "an obstacle in the newest scan"};
  if (const std::optional<Violation> conflict = FindConflictToSolve(committed, now, scene))
    return {GuardVerdict::Action::kYield, conflict->at, conflict->Reason()};
  return {};
}

}  // namespace citrine::planner

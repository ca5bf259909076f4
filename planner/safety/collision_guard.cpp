#include "planner/safety/collision_guard.h"

#include <algorithm>
#include <limits>

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
constexpr double kTeammateSize_m =
    0.3;  ///< hits this far beyond the radius around a teammate are the teammate

/// The i of [0, count) that is(i) says of. Listed without a branch: no processor could foresee it.
template <class Is>
std::vector<std::uint32_t> Where(std::size_t count, const Is& is) {
  std::vector<std::uint32_t> where(count);
  std::size_t found = 0;
  for (std::size_t i = 0; i < count; ++i) {
    where[found] = static_cast<std::uint32_t>(i);
    found += is(i);
  }
  where.resize(found);
  return where;
}

}  // namespace

double CollisionGuard::BoxLength(double speed_mps) const {
  return limits_.radius_m + speed_mps * kReaction_s + StoppingDistance(speed_mps, limits_);
}

void CollisionGuard::HearScan(const LidarScan& scan) {
  if (directions_.empty() || !(scan.model == model_)) {
    model_ = scan.model;
    directions_.clear();
    for (int row = 0; row < model_.rows; ++row)
      for (int col = 0; col < model_.cols; ++col)
        directions_.push_back(model_.Direction(row, col).cast<float>());
  }
  measured_ = scan.measured;
  hits_W_.clear();
  const double reach_m = BoxLength(limits_.speed_max_mps) + limits_.radius_m;
  const Eigen::Matrix3d R_WS = scan.X_WS.q.toRotationMatrix();
  const auto in_reach = Where(scan.ranges_m.size(), [&](std::size_t i) {
    return (scan.ranges_m[i] > 0) & (scan.ranges_m[i] < reach_m);
  });
  for (const std::uint32_t i : in_reach)
    hits_W_.push_back(R_WS * (scan.ranges_m[i] * directions_[i]).cast<double>() + scan.X_WS.p);
}

std::optional<Utime> CollisionGuard::FindHit(const Trajectory& committed, Utime now, const FlightScene& scene,
                                             double horizon_s) const {
  if (measured_ < 0 || now - measured_ > kStale) return std::nullopt;
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
  const Eigen::Vector3d ahead = travel.normalized();
  const double length = BoxLength(speed);

  const auto in_reach = Where(hits_W_.size(), [&](std::size_t i) {
    const double along = (hits_W_[i] - here.p_W).dot(ahead);
    return (along >= 0) & (along <= length);
  });
  std::optional<Utime> first;
  for (const std::uint32_t i : in_reach) {
    const Eigen::Vector3d &hit_W = hits_W_[i], offset = hit_W - here.p_W;
    if ((offset - offset.dot(ahead) * ahead).norm() > limits_.radius_m) continue;
    const bool is_teammate =
        std::any_of(scene.teammates.begin(), scene.teammates.end(), [&](const Teammate& other) {
          return (other.trajectory.At(measured_).p_W - hit_W).norm() < limits_.radius_m + kTeammateSize_m;
        });
    if (is_teammate) continue;
    const double asked = std::min(limits_.radius_m - kMapError_m, offset.norm() - kNearing_m);
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

#include "planner/trajectory/trajectory_check.h"

#include <algorithm>
#include <cstdio>

namespace citrine::planner {

namespace {

constexpr Utime kSample = 20'000;          ///< [us] 9 cm at 4.5 m/s
constexpr double kLimitTolerance = 1.002;  ///< of what a motion does between samples
constexpr double kClearanceTolerance_m = 1e-6;
constexpr double kVolumeTolerance_m = 1e-3;
constexpr double kJump = 1e-6;
constexpr double kRest_mps = 1e-3;

/// A distance that may not fall under what is asked, nor, while it is short of that, under what it has been.
class Keep {
 public:
  explicit Keep(double asked) : asked_(asked) {}
  bool Holds(double distance) {
    if (distance >= asked_ - kClearanceTolerance_m) {
      whole_ = true;
      return true;
    }
    if (whole_ || distance < most_ - kLoss_m) return false;
    most_ = std::max(most_, distance);
    return true;
  }

 private:
  static constexpr double kLoss_m = 0.02;
  double asked_;
  double most_ = -1e9;
  bool whole_ = false;
};

bool Jumps(const Trajectory& trajectory) {
  for (std::size_t i = 0; i + 1 < trajectory.segments.size(); ++i) {
    const TrajectorySegment& now = trajectory.segments[i];
    const double s = now.duration_s;
    const auto& c = now.coefficients;
    const Eigen::Vector4d p =
        c.col(0) + s * (c.col(1) + s * (c.col(2) + s * (c.col(3) + s * (c.col(4) + s * c.col(5)))));
    const Eigen::Vector4d v =
        c.col(1) + s * (2 * c.col(2) + s * (3 * c.col(3) + s * (4 * c.col(4) + s * 5 * c.col(5))));
    const Eigen::Vector4d a = 2 * c.col(2) + s * (6 * c.col(3) + s * (12 * c.col(4) + s * 20 * c.col(5)));
    const auto& next = trajectory.segments[i + 1].coefficients;
    const double gap =
        std::max({(p - next.col(0)).cwiseAbs().maxCoeff(), (v - next.col(1)).cwiseAbs().maxCoeff(),
                  (a - 2 * next.col(2)).head<3>().cwiseAbs().maxCoeff()});
    if (!(gap < kJump)) return true;
  }
  return false;
}

}  // namespace

std::string Violation::Reason() const {
  char text[96];
  switch (kind) {
    case Kind::kJump:
      return "the motion jumps";
    case Kind::kNoRest:
      return "the motion does not end at rest";
    case Kind::kSpeed:
      std::snprintf(text, sizeof text, "too fast: %.2f m/s", value);
      break;
    case Kind::kAcceleration:
      std::snprintf(text, sizeof text, "too hard: %.2f m/s^2", value);
      break;
    case Kind::kVolume:
      std::snprintf(text, sizeof text, "%.2f m outside of the mission volume", value);
      break;
    case Kind::kOccupied:
      std::snprintf(text, sizeof text, "an obstacle %.2f m from the way", value);
      break;
    case Kind::kUnknown:
      std::snprintf(text, sizeof text, "unknown space %.2f m from the way", value);
      break;
    case Kind::kTeammate:
      std::snprintf(text, sizeof text, "UAV %d comes as close as %.2f m", teammate, value);
      break;
  }
  return text;
}

std::optional<Violation> FindMapViolation(const Trajectory& trajectory, Utime from,
                                          const FlightScene& scene) {
  const PlanningMap& map = *scene.map;
  const double radius_m = scene.limits.radius_m;
  Keep occupied(std::min(radius_m, map.to_occupied().radius_m())),
      unknown(std::min(radius_m, map.to_unknown().radius_m()));
  Keep inside(-kVolumeTolerance_m);
  const Utime end = std::max(from, trajectory.end());
  for (Utime t = from;; t = std::min(t + kSample, end)) {
    const Eigen::Vector3d p_W = trajectory.At(t).p_W;
    const double outside = map.grid().volume_W().exteriorDistance(p_W);
    if (!inside.Holds(-outside)) return Violation{Violation::Kind::kVolume, t, outside};
    const double to_occupied = map.to_occupied().Interpolate(p_W);
    if (!occupied.Holds(to_occupied)) return Violation{Violation::Kind::kOccupied, t, to_occupied};
    const double to_unknown = map.to_unknown().Interpolate(p_W);
    if (!unknown.Holds(to_unknown)) return Violation{Violation::Kind::kUnknown, t, to_unknown};
    if (t >= end) return std::nullopt;
  }
}

std::optional<Violation> FindConflict(const Trajectory& trajectory, Utime from, const Teammate& teammate,
                                      double separation_m) {
  const Utime end = std::max({from, trajectory.end(), teammate.trajectory.end()});
  Keep apart(separation_m);
  // Two UAVs close in by at most 10 m/s or so: what is far apart now stays apart for a while.
  constexpr double kClosing_mps = 12;
  for (Utime t = from;;) {
    const double distance = (trajectory.At(t).p_W - teammate.trajectory.At(t).p_W).norm();
    if (!apart.Holds(distance)) return Violation{Violation::Kind::kTeammate, t, distance, teammate.uav};
    if (t >= end) return std::nullopt;
    t = std::min(end, t + std::max(kSample, FromSeconds((distance - separation_m) / kClosing_mps)));
  }
}

std::optional<Violation> FindViolation(const Trajectory& trajectory, Utime from, const FlightScene& scene) {
  if (Jumps(trajectory)) return Violation{Violation::Kind::kJump, trajectory.start};
  const Utime end = std::max(from, trajectory.end());
  for (Utime t = from; t < end; t += kSample) {
    const TrajectoryPoint x = trajectory.At(t);
    const double v = x.v_W.norm(), a = x.a_W.norm();
    if (!(v <= kLimitTolerance * scene.limits.speed_max_mps)) return Violation{Violation::Kind::kSpeed, t, v};
    if (!(a <= kLimitTolerance * scene.limits.acceleration_max_mps2))
      return Violation{Violation::Kind::kAcceleration, t, a};
  }
  Trajectory last;
  last.segments = {trajectory.segments.back()};
  last.segments[0].duration_s += 1;  // so that its former end is an ordinary instant
  if (last.At(FromSeconds(trajectory.segments.back().duration_s)).v_W.norm() > kRest_mps)
    return Violation{Violation::Kind::kNoRest, end};
  if (const auto violation = FindMapViolation(trajectory, from, scene)) return violation;
  for (const Teammate& teammate : scene.teammates)
    if (const auto violation = FindConflict(trajectory, from, teammate, scene.separation_m()))
      return violation;
  return std::nullopt;
}

}  // namespace citrine::planner

#include "planner/trajectory/brake.h"

#include <algorithm>
#include <cmath>

#include "planner/trajectory/minimum_jerk_spline.h"
#include "planner/trajectory/trajectory_cut.h"
#include "planner/trajectory/yaw.h"

namespace citrine::planner {

namespace {

constexpr double kPiece_s = 0.06;  ///< of the fit to the slowed motion
constexpr double kHardRamp_s = 0.2;
constexpr double kShare = 0.95;  ///< of the acceleration limit, for slowing down; turns come on top
constexpr double kShortest_s = 0.3;
constexpr double kFading_s = 0.3;
constexpr double kInstant_s = 1e-9;
constexpr double kAllInAll = 0.99;  ///< of the limit, turns included: the vehicle overshoots by 1 %
constexpr int kAttempts = 20;
constexpr double kSlower = 1.08;  ///< from one to the next
constexpr double kStill_mps = 1e-4;

/// Progress along the motion: its pace falls from 1 to 0, the deceleration a trapezoid with ramps of
/// `ramp_s`.
struct Slowing {
  double ramp_s, hold_s;
  double duration_s() const { return 2 * ramp_s + hold_s; }

  struct Progress {
    double along_s, pace, pace_rate;
  };
  Progress At(double t) const {
    const double peak = 1 / (ramp_s + hold_s);
    if (t > duration_s() / 2) {  // point-symmetric about the middle
      const Progress mirrored = At(duration_s() - t);
      return {t - duration_s() / 2 + mirrored.along_s, 1 - mirrored.pace, mirrored.pace_rate};
    }
    if (t < ramp_s)
      return {t - peak * t * t * t / (6 * ramp_s), 1 - peak * t * t / (2 * ramp_s), -peak * t / ramp_s};
    const double h = t - ramp_s, pace = 1 - peak * ramp_s / 2;
    return {ramp_s - peak * ramp_s * ramp_s / 6 + pace * h - peak * h * h / 2, pace - peak * h, -peak};
  }
};

Knot Slowed(const Trajectory& flown, Utime at, const Slowing& slowing, double t) {
  const Slowing::Progress s = slowing.At(t);
  const Utime whole = FromSeconds(s.along_s);
  const double rest_s = s.along_s - Seconds(whole);
  TrajectoryPoint x = flown.At(at + whole);
  x.p_W += x.v_W * rest_s;
  x.v_W += x.a_W * rest_s;
  x.a_W += x.j_W * rest_s;
  return {x.p_W, x.v_W * s.pace, x.a_W * s.pace * s.pace + x.v_W * s.pace_rate};
}

bool WithinLimits(const std::vector<TrajectorySegment>& pieces, double acceleration_max_mps2) {
  Trajectory motion;
  motion.segments = pieces;
  for (Utime t = 0; t < motion.end(); t += FromSeconds(kPiece_s / 3))
    if (motion.At(t).a_W.norm() > acceleration_max_mps2) return false;
  return true;
}

std::vector<TrajectorySegment> Fit(const Trajectory& flown, Utime at, const Slowing& slowing) {
  std::vector<TrajectorySegment> segments;
  Knot from = Slowed(flown, at, slowing, 0);
  double begin_s = 0;
  // A piece never spans two phases: along a straight, steady motion every phase is a cubic, and the fit
  // exact.
  for (const double phase_s : {slowing.ramp_s, slowing.hold_s, slowing.ramp_s}) {
    const int pieces = static_cast<int>(std::ceil(phase_s / kPiece_s));
    for (int i = 1; i <= pieces; ++i) {
      const double end_s = begin_s + phase_s * i / pieces;
      Knot to = Slowed(flown, at, slowing, end_s);
      if (end_s > slowing.duration_s() - kInstant_s) to.v = to.a = Eigen::Vector3d::Zero();
      segments.push_back(Quintic(from, to, phase_s / pieces));
      from = to;
    }
    begin_s += phase_s;
  }
  return segments;
}

}  // namespace

std::vector<TrajectorySegment> BrakeAlong(const Trajectory& flown, Utime at, const VehicleLimits& limits,
                                          Braking braking) {
  const TrajectoryPoint start = flown.At(at);
  const double left_s = Seconds(flown.end() - at);
  if (left_s <= 0 || (start.v_W.norm() < kStill_mps && start.a_W.norm() < kStill_mps))
    return left_s <= 0 ? std::vector<TrajectorySegment>{} : Cut(flown, at, flown.end());
  const double a = kShare * limits.acceleration_max_mps2;
  double fall_s = std::max(kShortest_s, start.v_W.norm() / a);  // of the pace at full deceleration
  const double most_mps2 = std::max(kAllInAll * limits.acceleration_max_mps2, start.a_W.norm());
  std::vector<TrajectorySegment> segments;
  bool within = false;
  for (int attempt = 0; !within && attempt < kAttempts; ++attempt, fall_s *= kSlower) {
    const double ramp_s = braking == Braking::kHard ? std::min(kHardRamp_s, fall_s / 2) : fall_s / 2;
    const Slowing slowing{ramp_s, fall_s - ramp_s};
    if (slowing.duration_s() / 2 >= left_s) return Cut(flown, at, flown.end());
    segments = Fit(flown, at, slowing);
    within = WithinLimits(segments, most_mps2);
  }
  // A motion that slows down hard by itself leaves nothing for a ramp as short.
  if (!within && braking == Braking::kHard) return BrakeAlong(flown, at, limits, Braking::kGentle);
  double duration_s = 0;
  for (const TrajectorySegment& segment : segments) duration_s += segment.duration_s;
  AddYaw(start.yaw_rad, start.yaw_rate_radps, start.yaw_rad + start.yaw_rate_radps * duration_s / 2,
         &segments);
  return segments;
}

double StoppingDistance(double speed_mps, const VehicleLimits& limits) {
  return speed_mps / 2 * (kHardRamp_s + speed_mps / (kShare * limits.acceleration_max_mps2));
}

Trajectory Onward(const TrajectoryPoint& state, Utime at) {
  Trajectory onward;
  onward.start = at;
  TrajectorySegment fading;
  fading.duration_s = kFading_s;
  fading.coefficients.col(0) << state.p_W, state.yaw_rad;
  fading.coefficients.col(1) << state.v_W, state.yaw_rate_radps;
  fading.coefficients.col(2).head<3>() = state.a_W / 2;
  fading.coefficients.col(3).head<3>() = -state.a_W / (6 * kFading_s);
  onward.segments = {fading};
  onward.segments[0].duration_s += 1;  // its end as an ordinary instant
  const TrajectoryPoint steady = onward.At(at + FromSeconds(kFading_s));
  onward.segments[0].duration_s = kFading_s;
  TrajectorySegment straight;
  straight.duration_s = 60;
  straight.coefficients.col(0) << steady.p_W, steady.yaw_rad;
  straight.coefficients.col(1) << steady.v_W, steady.yaw_rate_radps;
  onward.segments.push_back(straight);
  return onward;
}

}  // namespace citrine::planner

#include "planner/trajectory/yaw.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/pose.h"
#include "planner/trajectory/minimum_jerk_spline.h"
#include "planner/trajectory/trajectory_cut.h"

namespace citrine::planner {

namespace {

constexpr double kPeakOverMean = 1.875;  ///< of the rate of a quintic from rest to rest

}  // namespace

void AddYaw(double yaw_rad, double yaw_rate_radps, double goal_yaw_rad,
            std::vector<TrajectorySegment>* segments) {
  double duration_s = 0;
  for (const TrajectorySegment& segment : *segments) duration_s += segment.duration_s;
  if (duration_s <= 0) return;
  // Stopping the present turn takes half of its rate on the way; the rest of the turn is rest to rest.
  const double stopping = yaw_rate_radps * duration_s / 2;
  const double spare_radps = std::max(0.0, kYawRateMax_radps - std::abs(yaw_rate_radps));
  const double most = spare_radps * duration_s / kPeakOverMean;
  const double turn = stopping + std::clamp(WrapAngle(goal_yaw_rad - yaw_rad) - stopping, -most, most);
  Knot from, to;
  from.p.x() = yaw_rad;
  from.v.x() = yaw_rate_radps;
  to.p.x() = yaw_rad + turn;
  const TrajectorySegment whole = Quintic(from, to, duration_s);
  double begin_s = 0;
  for (TrajectorySegment& segment : *segments) {
    segment.coefficients.row(3) = Shifted(whole, begin_s, segment.duration_s).coefficients.row(0);
    begin_s += segment.duration_s;
  }
}

}  // namespace citrine::planner

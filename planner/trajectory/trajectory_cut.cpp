#include "planner/trajectory/trajectory_cut.h"

#include <algorithm>

namespace citrine::planner {

namespace {

constexpr double kInstant_s = 1e-9;

TrajectorySegment Still(const TrajectoryPoint& at, double duration_s) {
  TrajectorySegment segment;
  segment.duration_s = duration_s;
  segment.coefficients.col(0) << at.p_W, at.yaw_rad;
  return segment;
}

}  // namespace

TrajectorySegment Shifted(const TrajectorySegment& segment, double begin_s, double duration_s) {
  constexpr int kBinomial[6][6] = {{1},          {1, 1},          {1, 2, 1},
                                   {1, 3, 3, 1}, {1, 4, 6, 4, 1}, {1, 5, 10, 10, 5, 1}};
  TrajectorySegment shifted;
  shifted.duration_s = duration_s;
  for (int n = 0; n < 6; ++n) {
    double power = 1;
    for (int k = n; k >= 0; --k, power *= begin_s)
      shifted.coefficients.col(k) += kBinomial[n][k] * power * segment.coefficients.col(n);
  }
  return shifted;
}

std::vector<TrajectorySegment> Cut(const Trajectory& trajectory, Utime from, Utime to) {
  std::vector<TrajectorySegment> pieces;
  if (from < trajectory.start)
    pieces.push_back(Still(trajectory.At(trajectory.start), Seconds(std::min(to, trajectory.start) - from)));
  const double first_s = Seconds(from - trajectory.start), last_s = Seconds(to - trajectory.start);
  double begin_s = 0;
  for (const TrajectorySegment& segment : trajectory.segments) {
    const double lo = std::max(first_s - begin_s, 0.0), hi = std::min(last_s - begin_s, segment.duration_s);
    if (hi - lo > kInstant_s) pieces.push_back(Shifted(segment, lo, hi - lo));
    begin_s += segment.duration_s;
  }
  const double still_s = last_s - std::max(begin_s, first_s);
  if (still_s > kInstant_s) pieces.push_back(Still(trajectory.At(to), still_s));
  return pieces;
}

Trajectory Splice(const Trajectory& flown, Utime now, Utime at,
                  const std::vector<TrajectorySegment>& segments) {
  Trajectory spliced;
  spliced.start = now;
  spliced.segments = Cut(flown, now, at);
  spliced.segments.insert(spliced.segments.end(), segments.begin(), segments.end());
  return spliced;
}

}  // namespace citrine::planner

#include "core/trajectory/trajectory.h"

#include <algorithm>
#include <stdexcept>

namespace citrine {

namespace {

TrajectoryPoint Evaluate(const TrajectorySegment& segment, double s) {
  const auto& c = segment.coefficients;
  const Eigen::Vector4d x =
      c.col(0) + s * (c.col(1) + s * (c.col(2) + s * (c.col(3) + s * (c.col(4) + s * c.col(5)))));
  const Eigen::Vector4d v =
      c.col(1) + s * (2 * c.col(2) + s * (3 * c.col(3) + s * (4 * c.col(4) + s * 5 * c.col(5))));
  const Eigen::Vector4d a = 2 * c.col(2) + s * (6 * c.col(3) + s * (12 * c.col(4) + s * 20 * c.col(5)));
  const Eigen::Vector4d j = 6 * c.col(3) + s * (24 * c.col(4) + s * 60 * c.col(5));
  return {x.head<3>(), v.head<3>(), a.head<3>(), j.head<3>(), x(3), v(3)};
}

}  // namespace

double Trajectory::duration_s() const {
  double sum = 0;
  for (const TrajectorySegment& segment : segments) sum += segment.duration_s;
  return sum;
}

TrajectoryPoint Trajectory::At(Utime time) const {
  if (segments.empty()) throw std::logic_error("a trajectory without segments has no state");
  double s = Seconds(time - start);
  if (s <= 0) {
    TrajectoryPoint first = Evaluate(segments.front(), 0);
    if (s < 0) first.v_W = first.a_W = first.j_W = Eigen::Vector3d::Zero();
    return first;
  }
  for (const TrajectorySegment& segment : segments) {
    if (s < segment.duration_s) return Evaluate(segment, s);
    s -= segment.duration_s;
  }
  const TrajectoryPoint last = Evaluate(segments.back(), segments.back().duration_s);
  TrajectoryPoint rest;
  rest.p_W = last.p_W;
  rest.yaw_rad = last.yaw_rad;
  return rest;
}

Trajectory Hover(const Eigen::Vector3d& p_W, double yaw_rad, Utime start) {
  Trajectory hover;
  hover.start = start;
  TrajectorySegment segment;
  segment.coefficients.col(0) << p_W, yaw_rad;
  hover.segments.push_back(segment);
  return hover;
}

}  // namespace citrine

#include "planner/trajectory/flight_costs.h"

#include <algorithm>

namespace citrine::planner {

namespace {

/// The cost of the square of a vector beyond a limit, and its derivative by the vector.
double NormCost(double limit, const Eigen::Vector3d& x, double weight, Eigen::Vector3d* by) {
  const double hinge = x.squaredNorm() / (limit * limit) - 1;
  if (hinge <= 0) return 0;
  *by += weight * 6 * hinge * hinge / (limit * limit) * x;
  return weight * hinge * hinge * hinge;
}

}  // namespace

double ClearanceCost(const DistanceField& field, double clearance_m, const FlightSample& x, double weight,
                     FlightSample* by) {
  if (field.CertainlyBeyond(x.p, clearance_m)) return 0;
  Eigen::Vector3d gradient;
  const double hinge = clearance_m - field.Interpolate(x.p, &gradient);
  if (hinge <= 0) return 0;
  by->p -= weight * 3 * hinge * hinge * gradient;
  return weight * hinge * hinge * hinge;
}

double SpeedCost(double speed_max_mps, const FlightSample& x, double weight, FlightSample* by) {
  return NormCost(speed_max_mps, x.v, weight, &by->v);
}

double AccelerationCost(double acceleration_max_mps2, const FlightSample& x, double weight,
                        FlightSample* by) {
  return NormCost(acceleration_max_mps2, x.a, weight, &by->a);
}

double JerkCost(double jerk_max_mps3, const FlightSample& x, double weight, FlightSample* by) {
  return NormCost(jerk_max_mps3, x.j, weight, &by->j);
}

double VolumeCost(const Eigen::AlignedBox3d& box_W, const FlightSample& x, double weight, FlightSample* by) {
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double above = x.p[axis] - box_W.max()[axis], below = box_W.min()[axis] - x.p[axis];
    const double hinge = std::max({0.0, above, below});
    by->p[axis] += weight * 3 * hinge * hinge * (above > below ? 1 : -1);
    sum += weight * hinge * hinge * hinge;
  }
  return sum;
}

double TeammateCost(const Teammate& teammate, double separation_m, Utime start, const FlightSample& x,
                    double weight, FlightSample* by) {
  const Utime since = FromSeconds(x.t_s);
  const TrajectoryPoint other = teammate.trajectory.At(start + since);
  const Eigen::Vector3d apart = x.p - other.p_W - (x.t_s - Seconds(since)) * other.v_W;
  const double r2 = separation_m * separation_m;
  const double hinge = 1 - apart.squaredNorm() / r2;
  if (hinge <= 0) return 0;
  const double slope = -weight * 6 * hinge * hinge / r2;
  by->p += slope * apart;
  by->t_s -= slope * apart.dot(other.v_W);
  return weight * hinge * hinge * hinge;
}

}  // namespace citrine::planner

#include "planner/trajectory/flight_objective.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace citrine::planner {

namespace {

constexpr int kSamples = 10;  ///< a piece
constexpr double kOccupiedRoom_m = 0.2, kUnknownRoom_m = 0.12, kTeammateRoom_m = 0.3;
constexpr double kVolumeRoom_m = 0.05;
/// Beyond it the vehicle, whose thrust has to turn first, overshoots the acceleration.
constexpr double kJerkMax_mps3 = 36;

/// The six quintic Hermite functions and their first three derivatives at a share of a piece, in the order
/// p0, v0, a0, p1, v1, a1; v counts times the duration, a times its square.
struct Hermite {
  std::array<double, 6> value, first, second, third;
};

constexpr Hermite HermiteAt(double s) {
  const double s2 = s * s, s3 = s2 * s, s4 = s3 * s, s5 = s4 * s;
  return {
      {1 - 10 * s3 + 15 * s4 - 6 * s5, s - 6 * s3 + 8 * s4 - 3 * s5, s2 / 2 - 1.5 * s3 + 1.5 * s4 - s5 / 2,
       10 * s3 - 15 * s4 + 6 * s5, -4 * s3 + 7 * s4 - 3 * s5, s3 / 2 - s4 + s5 / 2},
      {-30 * s2 + 60 * s3 - 30 * s4, 1 - 18 * s2 + 32 * s3 - 15 * s4, s - 4.5 * s2 + 6 * s3 - 2.5 * s4,
       30 * s2 - 60 * s3 + 30 * s4, -12 * s2 + 28 * s3 - 15 * s4, 1.5 * s2 - 4 * s3 + 2.5 * s4},
      {-60 * s + 180 * s2 - 120 * s3, -36 * s + 96 * s2 - 60 * s3, 1 - 9 * s + 18 * s2 - 10 * s3,
       60 * s - 180 * s2 + 120 * s3, -24 * s + 84 * s2 - 60 * s3, 3 * s - 12 * s2 + 10 * s3},
      {-60 + 360 * s - 360 * s2, -36 + 192 * s - 180 * s2, -9 + 36 * s - 30 * s2, 60 - 360 * s + 360 * s2,
       -24 + 168 * s - 180 * s2, 3 - 24 * s + 30 * s2}};
}

constexpr std::array<Hermite, kSamples + 1> kHermite = [] {
  std::array<Hermite, kSamples + 1> table{};
  for (int j = 0; j <= kSamples; ++j)
    table[static_cast<std::size_t>(j)] = HermiteAt(static_cast<double>(j) / kSamples);
  return table;
}();

/// A Hermite sum over both knots of a piece, each derivative counted with its power of T, shifted by -order.
struct Weighed {
  Eigen::Vector3d value, by_duration;
};

double Scale(double T, int order) {
  double scale = 1;
  for (int k = 0; k < order; ++k) scale /= T;
  return scale;
}

Weighed Sum(const std::array<double, 6>& h, const Knot& k0, const Knot& k1, double T, int order) {
  const Eigen::Vector3d p = h[0] * k0.p + h[3] * k1.p;
  const Eigen::Vector3d v = h[1] * k0.v + h[4] * k1.v;
  const Eigen::Vector3d a = h[2] * k0.a + h[5] * k1.a;
  const double scale = Scale(T, order);
  return {scale * (p + T * v + T * T * a),
          scale / T * (-order * p + (1 - order) * T * v + (2 - order) * T * T * a)};
}

/// Adds the derivatives by both knots of a piece.
void Spread(const std::array<double, 6>& h, double T, int order, const Eigen::Vector3d& by, Knot* d0,
            Knot* d1) {
  const Eigen::Vector3d scaled = Scale(T, order) * by;
  d0->p += h[0] * scaled;
  d0->v += h[1] * T * scaled;
  d0->a += h[2] * T * T * scaled;
  d1->p += h[3] * scaled;
  d1->v += h[4] * T * scaled;
  d1->a += h[5] * T * T * scaled;
}

}  // namespace

FlightObjective::FlightObjective(const FlightScene& scene, const FlightWeights& weights, const Knot& start,
                                 const Knot& end, Utime begins)
    : scene_(scene), weights_(weights), start_(start), end_(end), begins_(begins) {
  for (const Teammate& teammate : scene.teammates) whereabouts_.emplace_back(teammate.trajectory, begins);
}

std::vector<double> FlightObjective::Pack(const std::vector<Eigen::Vector3d>& inner_W,
                                          const std::vector<double>& durations_s) {
  std::vector<double> x;
  for (const Eigen::Vector3d& p : inner_W) x.insert(x.end(), p.data(), p.data() + 3);
  for (const double T : durations_s) x.push_back(std::log(T));
  return x;
}

double FlightObjective::Evaluate(const std::vector<double>& x, std::vector<double>* gradient) {
  const std::size_t pieces = (x.size() + 3) / 4;
  std::vector<Knot> knots(pieces + 1);
  knots.front() = start_;
  knots.back() = end_;
  for (std::size_t i = 1; i < pieces; ++i) knots[i].p = Eigen::Map<const Eigen::Vector3d>(&x[3 * (i - 1)]);
  std::vector<double> durations_s(pieces);
  for (std::size_t i = 0; i < pieces; ++i) durations_s[i] = std::exp(x[3 * (pieces - 1) + i]);
  spline_.Solve(std::move(knots), std::move(durations_s));

  std::vector<Knot> by_knot(pieces + 1);
  std::vector<double> by_duration(pieces, weights_.time);
  double cost = spline_.JerkEnergy(&by_knot, &by_duration);
  for (const double T : spline_.durations_s()) cost += weights_.time * T;
  cost += SamplePieces(&by_knot, &by_duration);
  if (!gradient) return cost;
  spline_.PullBack(&by_knot, &by_duration);
  for (std::size_t i = 1; i < pieces; ++i) std::copy_n(by_knot[i].p.data(), 3, &(*gradient)[3 * (i - 1)]);
  for (std::size_t i = 0; i < pieces; ++i)
    (*gradient)[3 * (pieces - 1) + i] = by_duration[i] * spline_.durations_s()[i];
  return cost;
}

double FlightObjective::SamplePieces(std::vector<Knot>* by_knot, std::vector<double>* by_duration) const {
  double cost = 0, begin_s = 0;
  for (std::size_t i = 0; i < spline_.durations_s().size(); ++i) {
    const Knot &k0 = spline_.knots()[i], &k1 = spline_.knots()[i + 1];
    Knot &d0 = (*by_knot)[i], &d1 = (*by_knot)[i + 1];
    const double T = spline_.durations_s()[i];
    double by_begin = 0;
    for (int j = 0; j <= kSamples; ++j) {
      const Hermite& h = kHermite[static_cast<std::size_t>(j)];
      const double s = static_cast<double>(j) / kSamples;
      const Weighed p = Sum(h.value, k0, k1, T, 0), v = Sum(h.first, k0, k1, T, 1),
                    a = Sum(h.second, k0, k1, T, 2), jerk = Sum(h.third, k0, k1, T, 3);
      const double share = (j == 0 || j == kSamples ? 0.5 : 1.0) / kSamples;
      FlightSample by;
      const double rate =
          RateOfCost({p.value, v.value, a.value, jerk.value, begin_s + s * T}, share * T, &by);
      if (rate == 0) continue;
      cost += rate;
      Spread(h.value, T, 0, by.p, &d0, &d1);
      Spread(h.first, T, 1, by.v, &d0, &d1);
      Spread(h.second, T, 2, by.a, &d0, &d1);
      Spread(h.third, T, 3, by.j, &d0, &d1);
      (*by_duration)[i] += rate / T + by.p.dot(p.by_duration) + by.v.dot(v.by_duration) +
                           by.a.dot(a.by_duration) + by.j.dot(jerk.by_duration) + s * by.t_s;
      by_begin += by.t_s;
    }
    for (std::size_t before = 0; before < i; ++before) (*by_duration)[before] += by_begin;
    begin_s += T;
  }
  return cost;
}

double FlightObjective::RateOfCost(const FlightSample& x, double weight, FlightSample* by) const {
  const PlanningMap& map = *scene_.map;
  const VehicleLimits& limits = scene_.limits;
  const Eigen::Vector3d room = Eigen::Vector3d::Constant(kVolumeRoom_m);
  const Eigen::AlignedBox3d box_W(map.grid().volume_W().min() + room, map.grid().volume_W().max() - room);
  const double clearance = weights_.clearance * weight;
  double cost =
      ClearanceCost(map.to_occupied(), limits.radius_m + kOccupiedRoom_m, x, clearance, by) +
      ClearanceCost(map.to_unknown(), limits.radius_m + kUnknownRoom_m, x, clearance, by) +
      VolumeCost(box_W, x, clearance, by) +
      SpeedCost(kPlannedSpeed * limits.speed_max_mps, x, weights_.limits * weight, by) +
      AccelerationCost(kPlannedAcceleration * limits.acceleration_max_mps2, x, weights_.limits * weight, by) +
      JerkCost(kJerkMax_mps3, x, weights_.limits * weight, by);
  const double apart_m = scene_.separation_m() + kTeammateRoom_m;
  for (std::size_t i = 0; i < whereabouts_.size(); ++i)
    if (whereabouts_[i].MayBeNear(x.p, x.t_s, apart_m))
      cost += TeammateCost(scene_.teammates[i], apart_m, begins_, x, weights_.teammates * weight, by);
  return cost;
}

}  // namespace citrine::planner

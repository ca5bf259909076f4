#include "planner/trajectory/minimum_jerk_spline.h"

#include <utility>

namespace citrine::planner {

namespace {

/// What the end of a piece misses of its constant-acceleration prediction, and the energy's slopes by it.
struct Miss {
  Eigen::Vector3d p, v, a;
};

Miss MissOf(const Knot& k0, const Knot& k1, double T) {
  return {k1.p - k0.p - k0.v * T - k0.a * (T * T / 2), k1.v - k0.v - k0.a * T, k1.a - k0.a};
}

double Energy(const Miss& e, double T) {
  const double T2 = T * T, T3 = T2 * T, T4 = T3 * T, T5 = T4 * T;
  return 720 * e.p.squaredNorm() / T5 - 720 * e.p.dot(e.v) / T4 + 120 * e.p.dot(e.a) / T3 +
         192 * e.v.squaredNorm() / T3 - 72 * e.v.dot(e.a) / T2 + 9 * e.a.squaredNorm() / T;
}

Miss Slopes(const Miss& e, double T) {
  const double T2 = T * T, T3 = T2 * T, T4 = T3 * T, T5 = T4 * T;
  return {1440 / T5 * e.p - 720 / T4 * e.v + 120 / T3 * e.a, -720 / T4 * e.p + 384 / T3 * e.v - 72 / T2 * e.a,
          120 / T3 * e.p - 72 / T2 * e.v + 18 / T * e.a};
}

/// Derivative of Slopes by T alone.
Miss SlopesByDuration(const Miss& e, double T) {
  const double T2 = T * T, T3 = T2 * T, T4 = T3 * T, T5 = T4 * T, T6 = T5 * T;
  return {-7200 / T6 * e.p + 2880 / T5 * e.v - 360 / T4 * e.a,
          2880 / T5 * e.p - 1152 / T4 * e.v + 144 / T3 * e.a,
          -360 / T4 * e.p + 144 / T3 * e.v - 18 / T2 * e.a};
}

double Dot(const Miss& a, const Miss& b) { return a.p.dot(b.p) + a.v.dot(b.v) + a.a.dot(b.a); }

}  // namespace

void MinimumJerkSpline::Solve(std::vector<Knot> knots, std::vector<double> durations_s) {
  knots_ = std::move(knots);
  durations_s_ = std::move(durations_s);
  if (knots_.size() < 3) return;
  Factor();
  for (std::size_t i = 1; i + 1 < knots_.size(); ++i) knots_[i].v = knots_[i].a = Eigen::Vector3d::Zero();
  std::vector<Knot> y(knots_.size());
  JerkEnergy(&y);
  for (Knot& k : y) k.v = -k.v, k.a = -k.a;
  SolveInner(&y);
  for (std::size_t i = 1; i + 1 < knots_.size(); ++i) knots_[i].v = y[i].v, knots_[i].a = y[i].a;
}

void MinimumJerkSpline::Factor() {
  const std::size_t n = knots_.size();
  inverse_.assign(n, {});
  upper_.assign(n, {});
  Block carried{};  // what eliminating the knot before subtracts
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double T = durations_s_[i - 1], U = durations_s_[i];
    const Block d = {384 / (T * T * T) + 384 / (U * U * U) - carried.vv,
                     72 / (U * U) - 72 / (T * T) - carried.va, 72 / (U * U) - 72 / (T * T) - carried.av,
                     18 / T + 18 / U - carried.aa};
    const double det = d.vv * d.aa - d.va * d.av;
    inverse_[i] = {d.aa / det, -d.va / det, -d.av / det, d.vv / det};
    const Block u = upper_[i] = {336 / (U * U * U), -48 / (U * U), 48 / (U * U), -6 / U};
    const Block& m = inverse_[i];
    const Block mu = {m.vv * u.vv + m.va * u.av, m.vv * u.va + m.va * u.aa, m.av * u.vv + m.aa * u.av,
                      m.av * u.va + m.aa * u.aa};
    carried = {u.vv * mu.vv + u.av * mu.av, u.vv * mu.va + u.av * mu.aa, u.va * mu.vv + u.aa * mu.av,
               u.va * mu.va + u.aa * mu.aa};
  }
}

void MinimumJerkSpline::SolveInner(std::vector<Knot>* r) const {
  std::vector<Knot>& y = *r;
  const std::size_t n = y.size();
  const auto scaled = [&](std::size_t i) {
    const Block& m = inverse_[i];
    return Knot{{}, m.vv * y[i].v + m.va * y[i].a, m.av * y[i].v + m.aa * y[i].a};
  };
  for (std::size_t i = 1; i + 2 < n; ++i) {
    const Block& u = upper_[i];
    const Knot s = scaled(i);
    y[i + 1].v -= u.vv * s.v + u.av * s.a;
    y[i + 1].a -= u.va * s.v + u.aa * s.a;
  }
  for (std::size_t i = n - 2; i >= 1; --i) {
    if (i + 2 < n) {
      const Block& u = upper_[i];
      y[i].v -= u.vv * y[i + 1].v + u.va * y[i + 1].a;
      y[i].a -= u.av * y[i + 1].v + u.aa * y[i + 1].a;
    }
    const Knot s = scaled(i);
    y[i].v = s.v;
    y[i].a = s.a;
  }
}

double MinimumJerkSpline::JerkEnergy(std::vector<Knot>* by_knot, std::vector<double>* by_duration) const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    const Knot &k0 = knots_[i], &k1 = knots_[i + 1];
    const double T = durations_s_[i];
    const Miss e = MissOf(k0, k1, T);
    sum += Energy(e, T);
    if (!by_knot) continue;
    const Miss s = Slopes(e, T);
    Knot &d0 = (*by_knot)[i], &d1 = (*by_knot)[i + 1];
    d0.p -= s.p;
    d0.v -= T * s.p + s.v;
    d0.a -= T * T / 2 * s.p + T * s.v + s.a;
    d1.p += s.p;
    d1.v += s.v;
    d1.a += s.a;
    if (by_duration) {
      // The energy is a quadratic form of the miss: its derivative by T alone is half that of its slopes.
      (*by_duration)[i] += Dot(SlopesByDuration(e, T), e) / 2 - s.p.dot(k0.v + k0.a * T) - s.v.dot(k0.a);
    }
  }
  return sum;
}

void MinimumJerkSpline::PullBack(std::vector<Knot>* by_knot, std::vector<double>* by_duration) const {
  if (knots_.size() < 3) return;
  std::vector<Knot> lambda = *by_knot;
  lambda.front().v = lambda.front().a = lambda.back().v = lambda.back().a = Eigen::Vector3d::Zero();
  SolveInner(&lambda);
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i) {
    const Knot &k0 = knots_[i], &l0 = lambda[i], &l1 = lambda[i + 1];
    const double T = durations_s_[i];
    const Miss e = MissOf(k0, knots_[i + 1], T);
    // The directional derivative of the energy along lambda is zero at the solution: differentiate that by p
    // and T.
    const Miss along = {-(l0.v * T + l0.a * (T * T / 2)), l1.v - l0.v - l0.a * T, l1.a - l0.a};
    const Miss along_by_T = {-(l0.v + l0.a * T), -l0.a, Eigen::Vector3d::Zero()};
    const Miss e_by_T = {-(k0.v + k0.a * T), -k0.a, Eigen::Vector3d::Zero()};
    const Miss second = Slopes(along, T);
    (*by_knot)[i].p += second.p;
    (*by_knot)[i + 1].p -= second.p;
    (*by_duration)[i] -=
        Dot(SlopesByDuration(e, T), along) + Dot(second, e_by_T) + Dot(Slopes(e, T), along_by_T);
  }
}

std::vector<TrajectorySegment> MinimumJerkSpline::Segments() const {
  std::vector<TrajectorySegment> segments;
  for (std::size_t i = 0; i + 1 < knots_.size(); ++i)
    segments.push_back(Quintic(knots_[i], knots_[i + 1], durations_s_[i]));
  return segments;
}

TrajectorySegment Quintic(const Knot& from, const Knot& to, double duration_s) {
  const double T = duration_s;
  const Miss e = MissOf(from, to, T);
  TrajectorySegment segment;
  segment.duration_s = T;
  auto c = segment.coefficients.topRows<3>();
  c.col(0) = from.p;
  c.col(1) = from.v;
  c.col(2) = from.a / 2;
  c.col(3) = (10 * e.p - 4 * T * e.v + T * T / 2 * e.a) / (T * T * T);
  c.col(4) = (-15 * e.p + 7 * T * e.v - T * T * e.a) / (T * T * T * T);
  c.col(5) = (6 * e.p - 3 * T * e.v + T * T / 2 * e.a) / (T * T * T * T * T);
  return segment;
}

}  // namespace citrine::planner

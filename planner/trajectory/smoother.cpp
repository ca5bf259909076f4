#include "planner/trajectory/smoother.h"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "planner/trajectory/initial_guess.h"

namespace citrine::planner {

namespace {

// NLopt's L-BFGS fails on its first step where gradients are large: the objective is scaled to this steepest
// slope.
constexpr double kSteepest = 0.3;
constexpr double kRelativeCost = 1e-4, kRelativeStep = 1e-5;
constexpr int kMemory = 20;
constexpr double kShortest_s = 0.05, kLongest_s = 20;
constexpr double kPass_m = 0.13;  ///< half the edge of a cube within the ball of kReached_m

/// What NLopt calls: counts, scales, and keeps the best that was seen, whatever code the solver ends with.
struct Search {
  FlightObjective* objective;
  double scale = 1;
  int evaluations = 0;
  double best_cost = std::numeric_limits<double>::infinity();
  std::vector<double> x, gradient, best;

  double Evaluate() {
    ++evaluations;
    const double cost = objective->Evaluate(x, &gradient);
    if (cost < best_cost) best_cost = cost, best = x;
    return cost;
  }
};

double ScaledCost(unsigned n, const double* x, double* gradient, void* data) {
  auto* search = static_cast<Search*>(data);
  search->x.assign(x, x + n);
  const double cost = search->Evaluate();
  if (gradient)
    std::transform(search->gradient.begin(), search->gradient.end(), gradient,
                   [&](double g) { return g * search->scale; });
  return cost * search->scale;
}

struct Bounds {
  std::vector<double> lower, upper;
};

/// Durations stay reasonable, and the point that has to be passed near where it is.
Bounds BoundsOf(const InitialGuess& guess) {
  const std::size_t points = 3 * (guess.points_W.size() - 2), n = points + guess.durations_s.size();
  Bounds bounds{std::vector<double>(n, -HUGE_VAL), std::vector<double>(n, HUGE_VAL)};
  if (guess.pass)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t i = 3 * (*guess.pass - 1) + axis;
      bounds.lower[i] = guess.points_W[*guess.pass][static_cast<Eigen::Index>(axis)] - kPass_m;
      bounds.upper[i] = guess.points_W[*guess.pass][static_cast<Eigen::Index>(axis)] + kPass_m;
    }
  std::fill(bounds.lower.begin() + static_cast<std::ptrdiff_t>(points), bounds.lower.end(),
            std::log(kShortest_s));
  std::fill(bounds.upper.begin() + static_cast<std::ptrdiff_t>(points), bounds.upper.end(),
            std::log(kLongest_s));
  return bounds;
}

void Minimise(Search* search, const Bounds& bounds, int evaluations_max) {
  const auto n = static_cast<unsigned>(search->x.size());
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> solver(nlopt_create(NLOPT_LD_LBFGS, n),
                                                                 nlopt_destroy);
  nlopt_set_lower_bounds(solver.get(), bounds.lower.data());
  nlopt_set_upper_bounds(solver.get(), bounds.upper.data());
  nlopt_set_min_objective(solver.get(), ScaledCost, search);
  nlopt_set_vector_storage(solver.get(), kMemory);
  nlopt_set_ftol_rel(solver.get(), kRelativeCost);
  nlopt_set_xtol_rel(solver.get(), kRelativeStep);
  nlopt_set_maxeval(solver.get(), evaluations_max);
  std::vector<double> x = search->x;
  double cost = 0;
  nlopt_optimize(solver.get(), x.data(), &cost);
}

}  // namespace

SmoothingResult Smoother::Solve(const FlightScene& scene, const FlightWeights& weights,
                                const SmoothingTask& task, const SmoothingResult* warm) const {
  const InitialGuess guess = GuessAlong(task.points_W, task.start, scene.limits, task.pass_W);
  std::vector<Eigen::Vector3d> inner_W(guess.points_W.begin() + 1, guess.points_W.end() - 1);
  std::vector<double> durations_s = guess.durations_s;
  if (warm) {
    const std::vector<Knot>& knots = warm->spline.knots();
    inner_W.clear();
    for (std::size_t i = 1; i + 1 < knots.size(); ++i) inner_W.push_back(knots[i].p);
    durations_s = warm->spline.durations_s();
  }
  Knot end;
  end.p = task.points_W.back();
  FlightObjective objective(scene, weights, task.start, end, task.begins);

  Search search;
  search.objective = &objective;
  search.x = FlightObjective::Pack(inner_W, durations_s);
  search.gradient.resize(search.x.size());
  search.Evaluate();
  double steepest = 0;
  for (const double g : search.gradient) steepest = std::max(steepest, std::abs(g));
  if (steepest > 0) search.scale = kSteepest / steepest;
  Minimise(&search, BoundsOf(guess), evaluations_max_);

  SmoothingResult result;
  result.cost = objective.Evaluate(search.best, nullptr);
  result.spline = objective.spline();
  result.evaluations = search.evaluations;
  return result;
}

}  // namespace citrine::planner

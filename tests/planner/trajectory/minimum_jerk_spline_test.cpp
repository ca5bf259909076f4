#include "planner/trajectory/minimum_jerk_spline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "planner/path/path_search.h"
#include "planner/trajectory/flight_objective.h"
#include "planner/trajectory/smoother.h"
#include "planner/trajectory/trajectory_check.h"
#include "tests/planner/path/synthetic_map.h"

namespace citrine::planner {
namespace {

using Eigen::Vector3d;

Vector3d RandomVector(Random* random, double size) {
  return {random->Uniform(-size, size), random->Uniform(-size, size), random->Uniform(-size, size)};
}

TEST(MinimumJerkSpline, HasTheEnergyOfItsPolynomials) {
  Random random(1);
  const Knot from{RandomVector(&random, 3), RandomVector(&random, 2), RandomVector(&random, 2)};
  const Knot to{RandomVector(&random, 3), RandomVector(&random, 2), RandomVector(&random, 2)};
  MinimumJerkSpline spline;
  spline.Solve({from, to}, {1.3});
  Trajectory motion;
  motion.segments = spline.Segments();
  double integral = 0;
  constexpr int kSteps = 13000;
  for (int i = 0; i < kSteps; ++i) integral += motion.At(i * 100 + 50).j_W.squaredNorm() * 1.3 / kSteps;
  EXPECT_NEAR(spline.JerkEnergy(), integral, 1e-6 * integral);
}

TEST(MinimumJerkSpline, ContinuesJerkAndSnapAcrossInnerKnotsAsTheOptimumDoes) {
  Random random(2);
  std::vector<Knot> knots(5);
  for (Knot& knot : knots) knot.p = RandomVector(&random, 5);
  knots[0].v = RandomVector(&random, 2);
  MinimumJerkSpline spline;
  spline.Solve(knots, {0.9, 1.4, 0.7, 1.1});
  const auto segments = spline.Segments();
  for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
    const double T = segments[i].duration_s;
    const auto& c = segments[i].coefficients;
    const auto& next = segments[i + 1].coefficients;
    const double scale = 1 + c.cwiseAbs().maxCoeff();
    const Eigen::Vector4d jerk = 6 * c.col(3) + 24 * T * c.col(4) + 60 * T * T * c.col(5);
    const Eigen::Vector4d snap = 24 * c.col(4) + 120 * T * c.col(5);
    EXPECT_LT((jerk - 6 * next.col(3)).norm(), 1e-9 * scale);
    EXPECT_LT((snap - 24 * next.col(4)).norm(), 1e-8 * scale);
  }
}

TEST(FlightObjective, HasTheGradientOfFiniteDifferences) {
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    // Distances are piecewise trilinear: differences are exact only within one voxel, so the map is a plane,
    // linear all over.
    const PlanningMap map = MapOf(
        {16, 12, 8}, [](const Vector3d& p) { return p.z() - 1.5; },
        [](const Vector3d& p) { return p.y() < 10; });
    FlightScene scene;
    scene.map = &map;
    scene.limits.speed_max_mps = 2.5;  // so that every penalty acts
    scene.limits.acceleration_max_mps2 = 1.5;
    Trajectory other;
    other.segments = {Quintic({{14, 5, 3}, {-2, 0.3, 0}}, {{2, 7, 3}, {-1, 0, 0}}, 6)};
    scene.teammates = {{2, other}};
    Knot start{{2.0, 6.0, 3.2}, RandomVector(&random, 1.5), RandomVector(&random, 1)}, end;
    end.p = {13, 6.3, 3.1};
    FlightWeights weights;
    FlightObjective objective(scene, weights, start, end, 0);
    std::vector<Vector3d> inner_W;
    for (int i = 1; i < 5; ++i)
      inner_W.push_back(start.p + (end.p - start.p) * i / 5 + RandomVector(&random, 1.2));
    std::vector<double> durations_s;
    for (int i = 0; i < 5; ++i) durations_s.push_back(random.Uniform(0.6, 1.2));
    std::vector<double> x = FlightObjective::Pack(inner_W, durations_s), gradient(x.size());
    objective.Evaluate(x, &gradient);
    double largest = 0;
    for (const double g : gradient) largest = std::max(largest, std::abs(g));
    constexpr double kStep = 1e-5;
    for (std::size_t i = 0; i < x.size(); ++i) {
      std::vector<double> up = x, down = x;
      up[i] += kStep;
      down[i] -= kStep;
      const double difference =
          (objective.Evaluate(up, nullptr) - objective.Evaluate(down, nullptr)) / (2 * kStep);
      // A sample may cross from one voxel's trilinear patch into the next within the step; such kinks are of
      // the order 1e-6.
      EXPECT_NEAR(gradient[i], difference, 3e-6 * largest) << "variable " << i << " of trial " << trial;
    }
  }
}

TEST(Smoother, FliesAStraightLineInNearlyTheLeastTimeThatAQuinticNeeds) {
  const PlanningMap map = MapOf({30, 12, 8}, EmptySpace);
  FlightScene scene;
  scene.map = &map;
  SmoothingTask task;
  task.start.p = {3, 6, 4};
  task.points_W = {{3, 6, 4}, {9, 6, 4}};
  FlightWeights hurried;
  hurried.time = 1000;
  Trajectory motion;
  motion.segments = Smoother(300).Solve(scene, hurried, task).spline.Segments();
  // Rest to rest over L with one quintic: T = max(1.875 L / v, sqrt(5.774 L / a)). Several pieces may be
  // somewhat faster, but never than constant acceleration: L / v + v / a.
  const double closed_form_s = std::max(1.875 * 6 / 4.5, std::sqrt(5.774 * 6 / 4.8));
  EXPECT_GT(motion.duration_s(), 6 / 4.5 + 4.5 / 4.8);
  EXPECT_LT(motion.duration_s(), 1.1 * closed_form_s);
  for (Utime t = 0; t < motion.end(); t += 10'000)
    EXPECT_NEAR((motion.At(t).p_W - Vector3d(0, 6, 4)).tail<2>().norm(), 0, 1e-3);
}

TEST(Smoother, MatchesTheClosedFormOfJerkPlusTimeWhereNothingBinds) {
  const PlanningMap map = MapOf({30, 12, 8}, EmptySpace);
  FlightScene scene;
  scene.map = &map;
  SmoothingTask task;
  task.start.p = {6, 6, 4};
  task.points_W = {{6, 6, 4}, {6.5, 6, 4}};
  FlightWeights weights;
  weights.time = 30;
  const SmoothingResult result = Smoother(400).Solve(scene, weights, task);
  double duration_s = 0;
  for (const double T : result.spline.durations_s()) duration_s += T;
  // One quintic over L costs 720 L^2 / T^5 + w T, least at T = (3600 L^2 / w)^(1/6), of which its two halves
  // are one.
  EXPECT_NEAR(duration_s, std::pow(3600 * 0.25 / 30, 1.0 / 6), 0.03);  // the solver stops at 1e-4 of the cost
}

TEST(Smoother, GivesTheSameBitsEveryTime) {
  const Vector3d start(2.5, 2.5, 4), goal(21.5, 21, 4);
  const PlanningMap map = MapOf({24, 24, 8}, DistanceToForest(Forest(11, 24, 25, start, goal)));
  FlightScene scene;
  scene.map = &map;
  PathSearch search(map, scene.limits, 0.1);
  const auto path = search.Find(start, goal);
  ASSERT_TRUE(path);
  SmoothingTask task;
  task.start.p = start;
  for (const Waypoint& waypoint : path->waypoints) task.points_W.push_back(waypoint.p_W);
  const SmoothingResult a = Smoother(200).Solve(scene, {}, task), b = Smoother(200).Solve(scene, {}, task);
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_EQ(a.spline.durations_s(), b.spline.durations_s());
}

}  // namespace
}  // namespace citrine::planner

#include "planner/trajectory/flight_costs.h"

#include <gtest/gtest.h>

#include <functional>

#include "planner/trajectory/minimum_jerk_spline.h"
#include "planner/trajectory/whereabouts.h"
#include "tests/planner/path/synthetic_map.h"

namespace citrine::planner {
namespace {

using Eigen::Vector3d;

using Cost = std::function<double(const FlightSample& x, FlightSample* by)>;

constexpr double kWeight = 3;

/// Central differences of a cost by all thirteen numbers of a sample against the derivatives that it says.
/// Costs are cubic hinges: a step of 1e-5 leaves an error of the order 1e-10 of the third derivative.
void ExpectExactGradient(const Cost& cost, const FlightSample& x) {
  FlightSample said, none;
  ASSERT_GT(cost(x, &said), 0) << "the sample pays nothing";
  constexpr double kStep = 1e-5;
  const auto difference = [&](double FlightSample::*scalar, Vector3d FlightSample::*vector, int axis) {
    FlightSample up = x, down = x;
    (scalar ? up.*scalar : (up.*vector)[axis]) += kStep;
    (scalar ? down.*scalar : (down.*vector)[axis]) -= kStep;
    return (cost(up, &none) - cost(down, &none)) / (2 * kStep);
  };
  const double tolerance =
      1e-6 * (1 + said.p.norm() + said.v.norm() + said.a.norm() + said.j.norm() + std::abs(said.t_s));
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(said.p[axis], difference(nullptr, &FlightSample::p, axis), tolerance);
    EXPECT_NEAR(said.v[axis], difference(nullptr, &FlightSample::v, axis), tolerance);
    EXPECT_NEAR(said.a[axis], difference(nullptr, &FlightSample::a, axis), tolerance);
    EXPECT_NEAR(said.j[axis], difference(nullptr, &FlightSample::j, axis), tolerance);
  }
  EXPECT_NEAR(said.t_s, difference(&FlightSample::t_s, nullptr, 0), tolerance);
}

FlightSample Sample() {
  FlightSample x;
  x.p = {6.3, 5.9, 1.91};
  x.v = {3, -2.5, 1};
  x.a = {2, 4, -3};
  x.j = {30, -5, 20};
  x.t_s = 1.234'567;
  return x;
}

TEST(FlightCosts, ClearanceHasTheGradientOfFiniteDifferences) {
  const PlanningMap map = MapOf(
      {16, 12, 8}, [](const Vector3d& p) { return p.z() - 1; },
      [](const Vector3d& p) { return p.y() < 6.5; });
  for (const DistanceField* field : {&map.to_occupied(), &map.to_unknown()})
    ExpectExactGradient(
        [&](const FlightSample& x, FlightSample* by) { return ClearanceCost(*field, 1.2, x, kWeight, by); },
        Sample());
}

TEST(FlightCosts, SpeedHasTheGradientOfFiniteDifferences) {
  ExpectExactGradient([](const FlightSample& x, FlightSample* by) { return SpeedCost(3.5, x, kWeight, by); },
                      Sample());
}

TEST(FlightCosts, AccelerationHasTheGradientOfFiniteDifferences) {
  ExpectExactGradient(
      [](const FlightSample& x, FlightSample* by) { return AccelerationCost(4.8, x, kWeight, by); },
      Sample());
}

TEST(FlightCosts, JerkHasTheGradientOfFiniteDifferences) {
  ExpectExactGradient([](const FlightSample& x, FlightSample* by) { return JerkCost(25, x, kWeight, by); },
                      Sample());
}

TEST(FlightCosts, VolumeHasTheGradientOfFiniteDifferences) {
  const Eigen::AlignedBox3d box_W(Vector3d(0, 0, 2),
                                  Vector3d(6, 12, 8));  // left upwards in x, downwards in z
  ExpectExactGradient(
      [&](const FlightSample& x, FlightSample* by) { return VolumeCost(box_W, x, kWeight, by); }, Sample());
}

TEST(FlightCosts, TeammateHasTheGradientOfFiniteDifferencesInPlaceAndTime) {
  Teammate teammate{2, {}};
  teammate.trajectory.start = 3'000'000;
  teammate.trajectory.segments = {Quintic({{4, 5, 2}, {1, 0.5, 0}}, {{9, 7, 3}, {2, 0, 0}}, 2.5)};
  ExpectExactGradient(
      [&](const FlightSample& x, FlightSample* by) {
        return TeammateCost(teammate, 2.5, 3'200'000, x, kWeight, by);
      },
      Sample());
}

TEST(FlightCosts, AreZeroWhereAllIsWell) {
  const PlanningMap map = MapOf({16, 12, 8}, EmptySpace);
  FlightSample x, by;
  x.p = {8, 6, 4};
  EXPECT_EQ(ClearanceCost(map.to_occupied(), 1.2, x, kWeight, &by), 0);
  EXPECT_EQ(SpeedCost(4.5, x, kWeight, &by), 0);
  EXPECT_EQ(AccelerationCost(4.8, x, kWeight, &by), 0);
  EXPECT_EQ(JerkCost(40, x, kWeight, &by), 0);
  EXPECT_EQ(VolumeCost({Vector3d(0, 0, 0), Vector3d(16, 12, 8)}, x, kWeight, &by), 0);
  EXPECT_EQ(TeammateCost({2, Hover({12, 6, 4}, 0, 0)}, 2.5, 0, x, kWeight, &by), 0);
  EXPECT_EQ(by.p, Vector3d::Zero());
}

TEST(Whereabouts, NeverRuleOutAMotionThatIsNear) {
  Random random(6);
  for (int trial = 0; trial < 20; ++trial) {
    const auto vector = [&](double size) {
      return Vector3d(random.Uniform(-size, size), random.Uniform(-size, size), random.Uniform(-size, size));
    };
    Trajectory motion;
    motion.start = 1'000'000;
    motion.segments = {Quintic({vector(5), vector(4), vector(4)}, {vector(5)}, 3.3)};
    const Utime from = 1'400'000;
    const Whereabouts whereabouts(motion, from);
    int ruled_out = 0;
    for (int i = 0; i < 500; ++i) {
      const Vector3d p_W = vector(8);
      const double t_s = random.Uniform(0, 6);
      const bool near = (motion.At(from + FromSeconds(t_s)).p_W - p_W).norm() < 2.5;
      EXPECT_TRUE(!near || whereabouts.MayBeNear(p_W, t_s, 2.5));
      ruled_out += !whereabouts.MayBeNear(p_W, t_s, 2.5);
    }
    EXPECT_GT(ruled_out, 100);
  }
}

}  // namespace
}  // namespace citrine::planner

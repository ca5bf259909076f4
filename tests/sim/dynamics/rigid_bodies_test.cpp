#include "sim/dynamics/rigid_bodies.h"

#include <gtest/gtest.h>

#include "core/vehicle/airframe.h"
#include "tests/sim/dynamics/meshes.h"

namespace citrine::sim {
namespace {

const QuadrotorModel kModel;
constexpr double kDt_s = 0.002;

double Energy(const UavState& state) {
  const Eigen::Vector3d J_omega = kModel.inertia_kgm2.cwiseProduct(state.omega_B);
  return kModel.mass_kg * (kGravity_mps2 * state.X_WB.p.z() + state.v_W.squaredNorm() / 2) +
         state.omega_B.dot(J_omega) / 2;
}

TEST(RigidBodies, FallAsAParabola) {
  RigidBodies bodies({}, kModel, {{0, 0, 100}}, 1);
  bodies.Place(0, {{0, 0, 100}, Eigen::Quaterniond::Identity()}, {3, 0, 5});
  for (int k = 0; k < 500; ++k) bodies.Step(kDt_s);
  // Semi-implicit Euler is off by g t dt / 2 = 1 cm after a second.
  EXPECT_NEAR(bodies.state(0).X_WB.p.z(), 100 + 5 - kGravity_mps2 / 2, 0.011);
  EXPECT_NEAR(bodies.state(0).X_WB.p.x(), 3, 1e-9);
  EXPECT_NEAR(bodies.state(0).v_W.z(), 5 - kGravity_mps2, 1e-9);
}

TEST(RigidBodies, KeepTheirEnergyInFreeFallWhileSpinning) {
  RigidBodies bodies({}, kModel, {{0, 0, 100}}, 1);
  bodies.Exert(0, {0, {0.5, 0.3, 0.2}}, Eigen::Vector3d::Zero());
  bodies.Step(kDt_s);
  const double before = Energy(bodies.state(0));
  for (int k = 0; k < 500; ++k) bodies.Step(kDt_s);
  // Of 67 J turned into motion 0.2 % may go to the integrator (g^2 m t dt / 2 = 0.13 J).
  EXPECT_NEAR(Energy(bodies.state(0)), before, 0.14);
}

TEST(RigidBodies, KeepTheirMomentumWhenTwoCollide) {
  RigidBodies bodies({}, kModel, {{0, 0, 100}, {2, 0.1, 100}}, 1);
  bodies.Place(0, {{0, 0, 100}, Eigen::Quaterniond::Identity()}, {3, 0, 0});
  bodies.Place(1, {{2, 0.1, 100}, Eigen::Quaterniond::Identity()}, {-2, 0, 0});
  bool touched = false;
  for (int k = 0; k < 400; ++k) touched = !bodies.Step(kDt_s).empty() || touched;
  ASSERT_TRUE(touched);
  const Eigen::Vector3d sum = bodies.state(0).v_W + bodies.state(1).v_W;
  EXPECT_NEAR(sum.x(), 1, 1e-9);
  EXPECT_NEAR(sum.y(), 0, 1e-9);
  EXPECT_LT(bodies.state(0).v_W.x(), bodies.state(1).v_W.x());  // they part
}

class AWall : public testing::TestWithParam<bool> {};

TEST_P(AWall, StopsABodyFromEitherSideAndWhicheverWayItsTrianglesFace) {
  const TriMesh wall = Wall(2, GetParam());
  for (const double side : {-1.0, 1.0}) {
    RigidBodies bodies(wall, kModel, {{2 - 2 * side, 0, 5}}, 1);
    bodies.Place(0, {{2 - 2 * side, 0, 5}, Eigen::Quaterniond::Identity()}, {10 * side, 0, 0});
    double nearest = 2;
    for (int k = 0; k < 250; ++k) {
      bodies.Step(kDt_s);
      nearest = std::min(nearest, side * (2 - bodies.state(0).X_WB.p.x()));
    }
    EXPECT_GT(nearest, kAirframeRadius_m - 0.03) << "side " << side;  // one step at 10 m/s goes in 2 cm deep
    EXPECT_LT(nearest, kAirframeRadius_m + 1e-3) << "side " << side;
  }
}

INSTANTIATE_TEST_SUITE_P(Orientations, AWall, testing::Bool());

TEST(RigidBodies, SurviveAWorldWithTrianglesWithoutArea) {
  TriMesh wall = Wall(2);
  wall.triangles.push_back({0, 0, 1});
  RigidBodies bodies(wall, kModel, {{0, 0, 5}}, 1);
  bodies.Place(0, {{1, 0, 5}, Eigen::Quaterniond::Identity()}, {5, 0, 0});
  for (int k = 0; k < 250; ++k) bodies.Step(kDt_s);
  EXPECT_TRUE(bodies.state(0).X_WB.p.allFinite());
  EXPECT_LT(bodies.state(0).X_WB.p.x(), 2);
}

}  // namespace
}  // namespace citrine::sim

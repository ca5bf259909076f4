#include "sim/dynamics/rotors.h"

#include <gtest/gtest.h>

namespace citrine::sim {
namespace {

const QuadrotorModel kModel;

TEST(Rotors, BeginCarryingTheWeight) {
  EXPECT_NEAR(Rotors(kModel).thrusts_N().sum(), kModel.mass_kg * kGravity_mps2, 1e-12);
}

TEST(Rotors, ComeWithinOneOverEOfACommandedSpeedAfterOneTimeConstant) {
  Rotors rotors(kModel);
  const auto speed = [&] { return std::sqrt(rotors.thrusts_N()(0) / kModel.thrust_coefficient); };
  const double before = speed();
  for (int k = 0; k < 25; ++k) rotors.Step(Eigen::Vector4d::Constant(6), kModel.spin_up_s / 25);
  const double target = std::sqrt(6 / kModel.thrust_coefficient);
  EXPECT_NEAR((target - speed()) / (target - before), std::exp(-1.0), 1e-9);  // the step is exact
}

TEST(Rotors, GiveNoMoreAndNoLessThanTheyCan) {
  Rotors rotors(kModel);
  for (int k = 0; k < 1000; ++k) rotors.Step({1e3, -1e3, 1e3, -1e3}, 0.002);
  EXPECT_LE(rotors.thrusts_N().maxCoeff(), kModel.rotor_thrust_max_N() * (1 + 1e-12));
  EXPECT_GE(rotors.thrusts_N().minCoeff(), 0);
}

}  // namespace
}  // namespace citrine::sim

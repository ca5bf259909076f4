#include "sim/dynamics/mixer.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace citrine::sim {
namespace {

const QuadrotorModel kModel;

TEST(Mixer, ExertsExactlyWhatIsAskedWhereTheRotorsCan) {
  const Wrench asked{14.0, {0.1, -0.15, 0.05}};
  const Wrench got = WrenchOf(kModel, Mix(kModel, asked));
  EXPECT_NEAR(got.thrust_N, asked.thrust_N, 1e-12);
  EXPECT_NEAR((got.torque_B - asked.torque_B).norm(), 0, 1e-12);
}

TEST(Mixer, NeverLeavesTheRotorsLimits) {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const Wrench asked{random.Uniform(-20, 60),
                       {random.Uniform(-3, 3), random.Uniform(-3, 3), random.Uniform(-1, 1)}};
    const Eigen::Vector4d thrusts = Mix(kModel, asked);
    ASSERT_GE(thrusts.minCoeff(), 0);
    ASSERT_LE(thrusts.maxCoeff(), kModel.rotor_thrust_max_N());
  }
}

TEST(Mixer, KeepsRollAndPitchWhenYawAndThrustMustGiveWay) {
  const Wrench asked{kModel.thrust_max_N(), {0.4, -0.3, 0.6}};
  const Wrench got = WrenchOf(kModel, Mix(kModel, asked));
  EXPECT_NEAR((got.torque_B - asked.torque_B).head<2>().norm(), 0, 1e-12);
  EXPECT_LT(got.thrust_N, asked.thrust_N);
}

TEST(QuadrotorModel, LiftsTwiceItsWeight) {
  EXPECT_GE(kModel.thrust_max_N(), 2 * kModel.mass_kg * kGravity_mps2);
}

}  // namespace
}  // namespace citrine::sim

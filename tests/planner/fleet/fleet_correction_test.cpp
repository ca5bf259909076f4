#include "planner/fleet/fleet_correction.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace citrine::planner {
namespace {

constexpr Utime kSecond = 1'000'000;

std::vector<Eigen::Vector3d> Centroids(int n) {
  return std::vector<Eigen::Vector3d>(n, Eigen::Vector3d::Ones());
}

TeamMate MateOf(int uav, const FleetCorrection& c, bool alive = true) {
  return {uav, alive, c.replanning(), c.plan_id(), c.selections_left()};
}

TEST(FleetCorrection, TheLowerIdWinsWhenTwoClaimAtOnce) {
  FleetCorrection one(1, 2, 20), two(2, 2, 20);
  one.Claim();
  two.Claim();
  one.Update({MateOf(2, two)}, kSecond);
  two.Update({MateOf(1, one)}, kSecond);
  EXPECT_TRUE(one.claiming());
  EXPECT_FALSE(two.replanning());
}

TEST(FleetCorrection, NobodyBeginsWhileAMateReplansOrAnAssignmentIsUnresolved) {
  FleetCorrection one(1, 2, 20), two(2, 2, 20);
  EXPECT_TRUE(two.MayBegin({MateOf(1, one)}, 0));
  one.Claim();
  EXPECT_FALSE(two.MayBegin({MateOf(1, one)}, 0));
  EXPECT_TRUE(two.MayBegin({MateOf(1, one, false)}, 0));  // a silent mate hinders nobody
  const FleetAssignment assignment = one.Begin(Centroids(2), kSecond);
  ASSERT_TRUE(two.Hear(assignment, kSecond));
  two.CountSelection();
  two.CountSelection();
  EXPECT_FALSE(two.MayBegin({MateOf(1, one)}, 2 * kSecond));
}

TEST(FleetCorrection, IsReleasedOnceEveryLivingMateMadeItsSelections) {
  FleetCorrection one(1, 2, 20), two(2, 2, 20);
  const FleetAssignment assignment = one.Begin(Centroids(3), kSecond);
  two.Hear(assignment, kSecond);
  for (FleetCorrection* c : {&one, &two})
    for (int k = 0; k < 2; ++k) c->CountSelection();
  const TeamMate silent{3, false, false, 0, 0};
  one.Update({MateOf(2, two), {3, true, false, 0, 0}}, 2 * kSecond);
  EXPECT_TRUE(one.replanning());  // UAV 3 lives and has not even heard of it
  one.Update({MateOf(2, two), silent}, 3 * kSecond);
  EXPECT_FALSE(one.replanning());
  EXPECT_TRUE(two.MayBegin({MateOf(1, one), silent}, 3 * kSecond));
}

TEST(FleetCorrection, ExpiresWhoeverDidNotFinish) {
  FleetCorrection one(1, 2, 20), two(2, 2, 20);
  two.Hear(one.Begin(Centroids(2), 0), 0);
  one.Update({MateOf(2, two)}, 20 * kSecond);
  two.Update({MateOf(1, one)}, 20 * kSecond);
  EXPECT_FALSE(one.replanning());
  EXPECT_EQ(one.OwnToRepeat(20 * kSecond), nullptr);
  EXPECT_EQ(two.Current(20 * kSecond), nullptr);
  EXPECT_TRUE(two.MayBegin({MateOf(1, one)}, 20 * kSecond));
}

TEST(FleetCorrection, AllAgreeInWhateverOrderAssignmentsArrive) {
  // Two begun together (UAV 2 loses to UAV 1 although its id is the larger), and a later one or none.
  const FleetAssignment a{1 * kSecond * 16 + 1, 1, 21 * kSecond, 2, Centroids(3)};
  const FleetAssignment b{1 * kSecond * 16 + 2, 2, 21 * kSecond, 2, Centroids(3)};
  const FleetAssignment c{9 * kSecond * 16 + 2, 2, 29 * kSecond, 2, Centroids(3)};
  for (const bool later : {false, true}) {
    std::vector<const FleetAssignment*> order{&a, &a, &b, &b};
    if (later) order.push_back(&c);
    std::sort(order.begin(), order.end());
    do {
      FleetCorrection three(3, 2, 20);
      for (const FleetAssignment* heard : order) three.Hear(*heard, 10 * kSecond);
      ASSERT_EQ(three.plan_id(), later ? c.plan_id : a.plan_id);
      ASSERT_EQ(three.selections_left(), 2);
    } while (std::next_permutation(order.begin(), order.end()));
  }
}

TEST(FleetCorrection, HearsARepetitionOnce) {
  FleetCorrection one(1, 2, 20), two(2, 2, 20);
  const FleetAssignment assignment = one.Begin(Centroids(2), 0);
  EXPECT_TRUE(two.Hear(assignment, 0));
  two.CountSelection();
  EXPECT_FALSE(two.Hear(assignment, kSecond));
  EXPECT_EQ(two.selections_left(), 1);
}

}  // namespace
}  // namespace citrine::planner

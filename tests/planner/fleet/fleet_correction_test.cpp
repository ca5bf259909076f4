#include "planner/fleet/fleet_correction.h"

#include <algorithm>
#include <array>
#include <optional>

#include <gtest/gtest.h>

#include "core/random.h"

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

/// Three UAVs whose statuses and assignments arrive late, out of order, or not at all.
class Fleet {
 public:
  explicit Fleet(std::uint64_t seed) : random_(seed), heard_(3, std::vector<TeamMate>(3)) {
    for (int uav = 1; uav <= 3; ++uav) {
      fleet_.emplace_back(uav, 2, 20);
      for (int of = 0; of < 3; ++of) heard_[of][uav - 1] = MateOf(uav, fleet_.back());
    }
  }

  /// A step of 0.2 s; all UAVs see an imbalance whenever they look while `unbalanced`.
  void Step(bool unbalanced) {
    now_ += kSecond / 5;
    Deliver();
    for (int i = 0; i < 3; ++i) {
      FleetCorrection& c = fleet_[i];
      c.Update(Mates(i), now_);
      if (c.claiming() && random_.Below(2)) {
        if (random_.Below(5))
          c.Begin(Centroids(3), now_);
        else
          c.Release();
      } else if (unbalanced && random_.Below(4) == 0 && c.MayBegin(Mates(i), now_)) {
        c.Claim();
      }
      if (random_.Below(10) == 0) c.CountSelection();
      Say(i);
    }
  }
  bool Resting() const {
    return std::none_of(fleet_.begin(), fleet_.end(),
                        [](const FleetCorrection& c) { return c.replanning(); });
  }
  bool AllMayBegin() const {
    for (int i = 0; i < 3; ++i)
      if (!fleet_[i].MayBegin(Mates(i), now_)) return false;
    return true;
  }
  int begun() const { return begun_; }

 private:
  struct Message {
    Utime at;
    int to;
    TeamMate status;
    std::optional<FleetAssignment> assignment;
  };
  std::vector<TeamMate> Mates(int of) const {
    std::vector<TeamMate> mates;
    for (int i = 0; i < 3; ++i)
      if (i != of) mates.push_back(heard_[of][i]);
    return mates;
  }
  void Say(int from) {
    const FleetAssignment* own = fleet_[from].OwnToRepeat(now_);
    begun_ += own && own->plan_id != said_[from];
    if (own) said_[from] = own->plan_id;
    for (int to = 0; to < 3; ++to) {
      if (to == from || random_.Below(4) == 0) continue;
      messages_.push_back({now_ + random_.Below(1'500'000), to, MateOf(from + 1, fleet_[from]), {}});
      if (own) messages_.back().assignment = *own;
    }
  }
  void Deliver() {
    for (const Message& message : messages_) {
      if (message.at > now_) continue;
      heard_[message.to][message.status.uav - 1] = message.status;
      if (message.assignment) fleet_[message.to].Hear(*message.assignment, now_);
    }
    std::erase_if(messages_, [&](const Message& message) { return message.at <= now_; });
  }

  Random random_;
  Utime now_ = 0;
  std::vector<FleetCorrection> fleet_;
  std::vector<std::vector<TeamMate>> heard_;
  std::vector<Message> messages_;
  std::array<std::int64_t, 3> said_{};
  int begun_ = 0;
};

TEST(FleetCorrection, NeverLocksHoweverMessagesAreDelayedReorderedOrLost) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Fleet fleet(seed);
    for (int step = 0; step < 500; ++step) fleet.Step(true);
    EXPECT_GT(fleet.begun(), 3);                               // in 100 s: it goes on after each
    for (int step = 0; step < 125; ++step) fleet.Step(false);  // expiry and the longest delay
    ASSERT_TRUE(fleet.Resting()) << seed;
    ASSERT_TRUE(fleet.AllMayBegin()) << seed;
  }
}

}  // namespace
}  // namespace citrine::planner

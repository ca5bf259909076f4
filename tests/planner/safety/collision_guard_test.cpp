#include "planner/safety/collision_guard.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace citrine::planner {
namespace {

constexpr Utime kSample = 50'000;
constexpr double kHorizon_s = 1.5, kHorizonSpare_s = 0.5, kMapError_m = 0.2, kNearing_m = 0.05;

Trajectory Steady(const Eigen::Vector3d& from_W, const Eigen::Vector3d& v_W) {
  TrajectorySegment segment;
  segment.duration_s = 10;
  segment.coefficients.topLeftCorner<3, 1>() = from_W;
  segment.coefficients.block<3, 1>(0, 1) = v_W;
  return {1, 1, 0, {segment}};
}

Eigen::Vector3d RandomVector(Random& random) {
  return {random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1)};
}

/// @param returns  share of the beams
LidarScan RandomScan(Random& random, double returns) {
  LidarScan scan;
  scan.X_WS = {10 * RandomVector(random), Eigen::Quaterniond(Eigen::AngleAxisd(
                                              random.Uniform(0, 3), RandomVector(random).normalized()))};
  scan.model.rows = 24;
  scan.model.cols = 96;
  for (std::size_t i = 0; i < scan.model.num_beams(); ++i) {
    const float nothing = random.Below(2) ? kNoReturn : kInvalid;
    const auto range_m = static_cast<float>(random.Uniform(0.42, 10));
    scan.ranges_m.push_back(random.Uniform() < returns ? range_m : nothing);
  }
  return scan;
}

/// CollisionGuard::FindHit on a steady flight, all beams one after the other, in the world.
std::optional<Utime> TryEveryBeam(const LidarScan& scan, const Trajectory& flight,
                                  const CollisionGuard& guard, const VehicleLimits& limits) {
  const TrajectoryPoint here = flight.At(0);
  const double speed = here.v_W.norm();
  const double horizon_s = std::max(kHorizon_s, speed / limits.acceleration_max_mps2 + kHorizonSpare_s);
  std::optional<Utime> first;
  for (int row = 0; row < scan.model.rows; ++row)
    for (int col = 0; col < scan.model.cols; ++col) {
      const double range_m = scan.ranges_m[static_cast<std::size_t>(row * scan.model.cols + col)];
      if (!(range_m > 0 && range_m < guard.BoxLength(limits.speed_max_mps) + limits.radius_m)) continue;
      const Eigen::Vector3d hit_W = scan.X_WS * (range_m * scan.model.Direction(row, col));
      const Eigen::Vector3d offset = hit_W - here.p_W;
      const double along = offset.dot(here.v_W / speed);
      if (along < 0 || along > guard.BoxLength(speed) ||
          (offset - along * here.v_W / speed).norm() > limits.radius_m)
        continue;
      const double asked = std::min(limits.radius_m - kMapError_m, offset.norm() - kNearing_m);
      for (Utime t = 0; t < FromSeconds(horizon_s) && !(first && t >= *first); t += kSample)
        if ((flight.At(t).p_W - hit_W).norm() < asked) first = t;
    }
  return first;
}

TEST(CollisionGuard, FindsWhatTryingEveryBeamFinds) {
  Random random(11);
  const VehicleLimits limits;
  int hit = 0, missed = 0;
  for (int i = 0; i < 300; ++i) {
    const LidarScan scan = RandomScan(random, i % 2 ? 0.7 : 0.01);
    const Eigen::Vector3d from_W = scan.X_WS.p + 0.3 * RandomVector(random);
    const Trajectory flight =
        Steady(from_W, random.Uniform(0.3, limits.speed_max_mps) * RandomVector(random).normalized());
    CollisionGuard guard(1, limits);
    guard.HearScan(scan);
    const std::optional<Utime> expected = TryEveryBeam(scan, flight, guard, limits);
    ASSERT_EQ(guard.FindHit(flight, 0, {nullptr, limits, {}}), expected) << "scene " << i;
    ++(expected ? hit : missed);
  }
  EXPECT_GT(hit, 50);
  EXPECT_GT(missed, 50);
}

TEST(CollisionGuard, FollowsAScanOfAnotherModel) {
  Random random(12);
  const VehicleLimits limits;
  CollisionGuard guard(1, limits);
  guard.HearScan(RandomScan(random, 0.5));
  LidarScan wall;
  wall.model.rows = 3;
  wall.model.cols = 8;
  wall.ranges_m.assign(wall.model.num_beams(), 2.0f);
  guard.HearScan(wall);
  const Eigen::Vector3d ahead = wall.model.Direction(1, 4);
  EXPECT_TRUE(guard.FindHit(Steady({0, 0, 0}, 2 * ahead), 0, {nullptr, limits, {}}));
}

}  // namespace
}  // namespace citrine::planner

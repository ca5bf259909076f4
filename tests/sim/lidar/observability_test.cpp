#include "sim/lidar/observability.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "tests/sim/box_world.h"
#include "tests/support/scratch_folder.h"

namespace citrine::sim {
namespace {

/// A table that stands low over the ground beside a block, with a niche that nobody reaches into.
class ObservabilityOfATable : public testing::Test {
 protected:
  World world_ = BoxWorld({{"ground", Box(-6, -6, -0.5, 6, 6, 0)},
                           {"table", Box(-2, -2, 0.3, 2, 2, 0.8)},
                           {"block", Box(2.4, -2, 0, 5, 2, 4)}});
  RayScene scene_{world_};
  Eigen::AlignedBox3d volume_W_ = Box(-6, -6, 0, 6, 6, 7);
  TrueSurface surface_ = SampleTrueSurface(world_, scene_, volume_W_, 4, 1);
  ReachableLattice lattice_ = FindReachable(scene_, volume_W_, {{-4, -4, 3}}, 1.0);
  LidarModel model_;
  QualityGoals goals_{QualityGoal::FromDistance(2.0)};
};

TEST_F(ObservabilityOfATable, AgreesWithLookingFromEveryPose) {
  const Observability flags = FindObservable(surface_.samples, lattice_, scene_, model_, goals_);
  ASSERT_EQ(flags.observable.size(), surface_.samples.size());
  int hidden = 0, far = 0;
  for (std::size_t i = 0; i < surface_.samples.size(); ++i) {
    bool observable = false, within_goal = false;
    for (std::size_t k = 0; k < lattice_.reachable.size() && !within_goal; ++k) {
      if (!lattice_.reachable[k]) continue;
      const Eigen::Vector3f from_W = lattice_.Position(lattice_.FromLinear(k)).cast<float>(),
                            ray = surface_.samples[i].p_W - from_W;
      const double elevation_rad = std::asin(ray.z() / ray.norm());
      if (ray.norm() < model_.range_min_m || ray.norm() > model_.range_max_m) continue;
      if (elevation_rad < model_.elevation_min_rad || elevation_rad > model_.elevation_max_rad) continue;
      if (scene_.Occluded(from_W, surface_.samples[i].p_W)) continue;
      observable = true;
      within_goal = ray.norm() <= 2.0;
    }
    EXPECT_EQ(flags.observable[i], observable) << surface_.samples[i].p_W.transpose();
    EXPECT_EQ(flags.within_goal[i], within_goal) << surface_.samples[i].p_W.transpose();
    hidden += !observable;
    far += observable && !within_goal;
  }
  EXPECT_GT(hidden, 10);  // under the table
  EXPECT_GT(far, 10);     // seen, but from no nearer than 2 m
}

TEST_F(ObservabilityOfATable, IsReadBackFromTheCacheAsItWasFound) {
  const ScratchFolder folder;
  const std::string cache = (folder.path() / "cache").string();
  const auto find = [&] {
    return FindObservableCached(cache, surface_.samples, lattice_, scene_, model_, goals_);
  };
  const Observability found = find();
  ASSERT_EQ(std::distance(std::filesystem::directory_iterator(cache), {}), 1);
  const Observability kept = find();
  EXPECT_EQ(kept.observable, found.observable);
  EXPECT_EQ(kept.within_goal, found.within_goal);
  EXPECT_EQ(found.observable, FindObservable(surface_.samples, lattice_, scene_, model_, goals_).observable);
}

TEST_F(ObservabilityOfATable, TakesNothingFromADamagedCacheOrFromThatOfAnotherGoal) {
  const ScratchFolder folder;
  const std::string cache = (folder.path() / "cache").string();
  const Observability found = FindObservableCached(cache, surface_.samples, lattice_, scene_, model_, goals_);
  const std::filesystem::path file = std::filesystem::directory_iterator(cache)->path();
  {
    std::fstream damage(file, std::ios::in | std::ios::out | std::ios::binary);
    damage.seekp(3);
    damage.put(2);
  }
  EXPECT_EQ(FindObservableCached(cache, surface_.samples, lattice_, scene_, model_, goals_).within_goal,
            found.within_goal);
  const QualityGoals whole(QualityGoal::FromDistance(10));
  const Observability other = FindObservableCached(cache, surface_.samples, lattice_, scene_, model_, whole);
  EXPECT_EQ(other.within_goal, other.observable);
}

}  // namespace
}  // namespace citrine::sim

#include "modules/mission_report/ground_truth.h"

#include <algorithm>
#include <cmath>

#include "sim/lidar/reachability.h"

namespace citrine {
namespace {

std::optional<double> Percent(std::size_t part, std::size_t whole) {
  if (whole == 0) return std::nullopt;
  return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

/// What has been counted up to the end of each second, in percent of the whole.
logs::Series ShareOverTime(const std::vector<std::size_t>& in_second, std::size_t whole) {
  logs::Series share;
  std::size_t so_far = 0;
  for (std::size_t second = 0; second < in_second.size() && whole > 0; ++second) {
    so_far += in_second[second];
    share.emplace_back(static_cast<double>(second + 1), *Percent(so_far, whole));
  }
  return share;
}

}  // namespace

GroundTruth::GroundTruth(const MissionConfig& config, const std::vector<Eigen::Vector3d>& spawns_W,
                         const std::string& cache_folder)
    : config_(config),
      world_(sim::LoadWorld(config.mission.world)),
      scene_(world_),
      surface_(sim::SampleTrueSurface(world_, scene_, config.volume_W(), kSamplesPerM2, kSeed)) {
  const sim::ReachableLattice lattice =
      sim::FindReachable(scene_, config.volume_W(), spawns_W, config.uav.limits.radius_m);
  flags_ = cache_folder.empty() ? sim::FindObservable(surface_.samples, lattice, scene_, config.lidar.model,
                                                      config.quality_goals())
                                : sim::FindObservableCached(cache_folder, surface_.samples, lattice, scene_,
                                                            config.lidar.model, config.quality_goals());
}

std::optional<double> GroundTruth::observable_share() const {
  const auto count = std::count(flags_.observable.begin(), flags_.observable.end(), 1);
  const auto percent = Percent(static_cast<std::size_t>(count), flags_.observable.size());
  if (!percent) return std::nullopt;
  return *percent / 100;
}

std::optional<logs::ReconstructionScore> GroundTruth::Score(const TriMesh& reconstruction) const {
  logs::ScoreTruth truth;
  for (const sim::SurfaceSample& sample : surface_.samples) truth.samples_W.push_back(sample.p_W);
  truth.observable = flags_.observable;
  truth.distance = [&](const Eigen::Vector3d& p_W) { return scene_.Distance(p_W); };
  logs::ScoreOptions options;
  options.threshold_m = std::sqrt(1.5) * config_.map.voxel_m;
  options.seed = kSeed;
  return logs::ScoreReconstruction(reconstruction, truth, options);
}

GroundTruth::GoalCoverage GroundTruth::SeenFrom(std::vector<logs::Timed<Pose>> X_WS) const {
  std::stable_sort(X_WS.begin(), X_WS.end(), [](const auto& a, const auto& b) { return a.utime < b.utime; });
  std::vector<Pose> poses_W;
  for (const auto& scan : X_WS) poses_W.push_back(scan.value);
  const std::vector<int> first =
      sim::FirstSeenBy(surface_.samples, poses_W, scene_, config_.lidar.model, config_.quality_goals());

  const auto second_of = [](Utime utime) { return static_cast<std::size_t>(Seconds(utime)); };
  const std::size_t seconds = X_WS.empty() ? 1 : second_of(X_WS.back().utime) + 1;
  std::size_t all = 0, objects = 0;
  std::vector<std::size_t> all_in(seconds, 0), objects_in(seconds, 0);
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (flags_.within_goal[i] == 0) continue;
    const bool object = !surface_.samples[i].ground;
    ++all;
    objects += object;
    if (first[i] < 0) continue;
    const std::size_t second = second_of(X_WS[static_cast<std::size_t>(first[i])].utime);
    ++all_in[second];
    objects_in[second] += object;
  }
  return {ShareOverTime(all_in, all), ShareOverTime(objects_in, objects)};
}

}  // namespace citrine

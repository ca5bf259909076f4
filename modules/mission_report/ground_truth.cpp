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

GroundTruth::GoalCoverage GroundTruth::SeenFrom(const std::vector<Pose>& X_WS) const {
  const std::vector<std::uint8_t> seen =
      sim::SeenBy(surface_.samples, X_WS, scene_, config_.lidar.model, config_.quality_goals());
  std::size_t all = 0, all_seen = 0, objects = 0, objects_seen = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (flags_.within_goal[i] == 0) continue;
    const bool object = !surface_.samples[i].ground;
    ++all;
    all_seen += seen[i] != 0;
    objects += object;
    objects_seen += object && seen[i] != 0;
  }
  return {Percent(all_seen, all), Percent(objects_seen, objects)};
}

}  // namespace citrine

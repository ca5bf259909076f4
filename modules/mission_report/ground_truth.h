#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/config/mission_config.h"
#include "core/geometry/pose.h"
#include "logs/flight_measures.h"
#include "logs/reconstruction_score.h"
#include "sim/lidar/observability.h"
#include "sim/lidar/ray_scene.h"
#include "sim/world/true_surface.h"
#include "sim/world/world.h"

namespace citrine {

/// The true world of a mission, and what of it could be seen.
class GroundTruth {
 public:
  static constexpr double kSamplesPerM2 = 40;  ///< of the true surface
  static constexpr std::uint64_t kSeed = 1;

  /// @param spawns_W      where the UAVs began
  /// @param cache_folder  keeps what can be observed of a world; empty: found anew
  /// @throws sim::WorldError, ConfigError
  GroundTruth(const MissionConfig& config, const std::vector<Eigen::Vector3d>& spawns_W,
              const std::string& cache_folder);

  const sim::World& world() const { return world_; }
  /// [0, 1] of the world's surface in the volume that has solid on both sides and is left out.
  double dropped_share() const { return surface_.dropped_share; }
  std::optional<double> observable_share() const;

  std::optional<logs::ReconstructionScore> Score(const TriMesh& reconstruction) const;

  /// [m] from a point to the true surface.
  double Clearance(const Eigen::Vector3d& p_W) const { return scene_.Distance(p_W); }

  /// Of the true surface that a reachable pose sees from within d*, the share [%] that has been so seen from
  /// the poses of scans; a step every second of the mission. Both are empty if no reachable pose sees any of
  /// it.
  struct GoalCoverage {
    logs::Series all_pct;
    logs::Series objects_pct;  ///< without the ground
  };
  GoalCoverage SeenFrom(std::vector<logs::Timed<Pose>> X_WS) const;

 private:
  MissionConfig config_;
  sim::World world_;
  sim::RayScene scene_;
  sim::TrueSurface surface_;
  sim::Observability flags_;
};

}  // namespace citrine

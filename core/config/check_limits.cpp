#include "core/config/check_limits.h"

#include "core/config/number_text.h"

namespace citrine {
namespace {

constexpr double kSpawnHeightMin_m = 2.25;  // above the volume's floor: room for the ball of known free space

void Exceeds(const std::string& upper_key, double upper, const std::string& lower_key, double lower) {
  if (upper > lower) return;
  throw ConfigError(upper_key + " must exceed " + lower_key + " (" + NumberText(lower) + "), is " +
                    NumberText(upper));
}

void Ordered(const std::string& section, const Eigen::Vector3d& min_m, const std::string& min_key,
             const Eigen::Vector3d& max_m, const std::string& max_key) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string index = "[" + std::to_string(axis) + "]";
    Exceeds(section + max_key + index, max_m[axis], section + min_key + index, min_m[axis]);
  }
}

void NotFasterThanSteps(const std::string& key, double rate_hz, double step_s) {
  if (rate_hz * step_s <= 1 + 1e-9) return;
  throw ConfigError(key + " must not exceed 1 / dynamics.step_s (" + NumberText(1 / step_s) + "), is " +
                    NumberText(rate_hz));
}

void CheckVolumeAndSpawns(const MissionSection& mission) {
  if (mission.volume_min_m.has_value() != mission.volume_max_m.has_value())
    throw ConfigError("mission.volume_min_m and mission.volume_max_m must be set both or neither");
  if (mission.volume_min_m)
    Ordered("mission.", *mission.volume_min_m, "volume_min_m", *mission.volume_max_m, "volume_max_m");
  for (std::size_t i = 0; i < mission.spawns_m.size(); ++i) {
    const Eigen::Vector3d& p_W = mission.spawns_m[i];
    const std::string key = "mission.spawns_m[" + std::to_string(i) + "]";
    if (!mission.volume_min_m) continue;
    const double z_min_m = mission.volume_min_m->z() + kSpawnHeightMin_m;
    if (p_W.z() < z_min_m)
      throw ConfigError(key + ": z must be at least " + NumberText(z_min_m) + ", is " + NumberText(p_W.z()));
    if (!Eigen::AlignedBox3d(*mission.volume_min_m, *mission.volume_max_m).contains(p_W))
      throw ConfigError(key + ": must lie inside the mission volume, is " + VectorText(p_W));
  }
}

}  // namespace

void CheckLimits(const MissionConfig& config) {
  const LidarModel& lidar = config.lidar.model;
  CheckVolumeAndSpawns(config.mission);
  Exceeds("lidar.range_max_m", lidar.range_max_m, "lidar.range_min_m", lidar.range_min_m);
  if (lidar.rows > 1)
    Exceeds("lidar.elevation_max_rad", lidar.elevation_max_rad, "lidar.elevation_min_rad",
            lidar.elevation_min_rad);
  Exceeds("map.truncation_m", config.map.truncation_m, "map.voxel_m", config.map.voxel_m);
  Exceeds("quality.d_star_m", config.quality.d_star_m, "quality.eta_m", config.quality.eta_m);
  Exceeds("quality.d_star_m", config.quality.d_star_m, "lidar.range_min_m", lidar.range_min_m);
  for (std::size_t i = 0; i < config.quality_regions.size(); ++i) {
    const QualityRegionSection& region = config.quality_regions[i];
    const std::string path = "quality.region[" + std::to_string(i) + "].";
    Ordered(path, region.min_m, "min_m", region.max_m, "max_m");
    Exceeds(path + "d_star_m", region.d_star_m, "quality.eta_m", config.quality.eta_m);
    Exceeds(path + "d_star_m", region.d_star_m, "lidar.range_min_m", lidar.range_min_m);
  }
  NotFasterThanSteps("lidar.rate_hz", config.lidar.rate_hz, config.dynamics.step_s);
  NotFasterThanSteps("map.publish_hz", config.map.publish_hz, config.dynamics.step_s);
  NotFasterThanSteps("smoother.guard_hz", config.smoother.guard_hz, config.dynamics.step_s);
}

}  // namespace citrine

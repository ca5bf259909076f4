#include "core/config/mission_config.h"

namespace citrine {

QualityGoals MissionConfig::quality_goals() const {
  const auto goal = [&](double d_star_m) {
    return QualityGoal::FromDistance(std::min(d_star_m, lidar.model.range_max_m));
  };
  std::vector<QualityGoals::Region> regions;
  for (const QualityRegionSection& region : quality_regions)
    regions.push_back({Eigen::AlignedBox3d(region.min_m, region.max_m), goal(region.d_star_m)});
  return QualityGoals(goal(quality.d_star_m), std::move(regions));
}

Eigen::AlignedBox3d MissionConfig::volume_W() const {
  if (!mission.volume_min_m || !mission.volume_max_m)
    throw ConfigError("mission.volume_min_m and mission.volume_max_m are not set");
  return {*mission.volume_min_m, *mission.volume_max_m};
}

}  // namespace citrine

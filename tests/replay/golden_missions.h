#pragma once

#include <string>
#include <vector>

namespace citrine::test {

/// A mission whose recording is part of the tests: logs/golden/<name>/mission.lcmlog.
struct GoldenMission {
  std::string name;
  std::vector<std::string>
      overrides;  ///< of missions/smoke.toml; coarse sensors, so that the logs stay small
};

inline std::vector<GoldenMission> GoldenMissions() {
  return {
      {"smoke",
       {"viz.pixels_per_m=24", "lidar.rows=16", "lidar.cols=192", "map.octree_hz=0.2", "map.rotation_s=60"}},
      {"smoke_three_uavs",
       {"viz.pixels_per_m=24", "mission.uavs=3", "mission.seed=2", "mission.time_limit_s=4",
        "lidar.cols=256"}}};
}

inline std::string GoldenFolder(const std::string& mission) {
  return std::string(CITRINE_SOURCE_DIR) + "/logs/golden/" + mission;
}

}  // namespace citrine::test

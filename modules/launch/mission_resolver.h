#pragma once

#include <memory>
#include <string>

#include "core/config/mission_config.h"
#include "modules/codec/mission_config_text.h"
#include "modules/launch/run_options.h"
#include "sim/world/world.h"

namespace citrine {

/// A mission that can be flown: nothing is left open, and its world has been looked at.
struct ResolvedMission {
  MissionConfig
      config;        ///< with volume, spawns (moved by the seed), world and result folder as absolute paths
  std::string toml;  ///< the same as text
  std::shared_ptr<const sim::World> world;  ///< as read to place the UAVs
  MissionConfigText flown;                  ///< what MISSION_CONFIG says
};

/// @throws ConfigError, sim::WorldError
ResolvedMission ResolveMission(const RunOptions& options);

}  // namespace citrine

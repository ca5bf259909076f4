#pragma once

#include <compare>
#include <string>
#include <vector>

#include "core/config/mission_config.h"

namespace citrine {

/// One module of a mission.
struct ModuleId {
  std::string name;
  int uav = 0;  ///< 1..N in a module that serves one UAV, else 0

  auto operator<=>(const ModuleId&) const = default;
};

/// "view_planner (UAV 2)"
std::string ToText(const ModuleId& id);
/// As above, with commas.
std::string ToText(const std::vector<ModuleId>& ids);

/// The modules that fly a mission, in order; in lockstep all wait for each of them.
std::vector<ModuleId> ModulesOf(const MissionConfig& config);

/// Mission, strategy and seed: what two runs that must be equal have in common.
std::string MissionId(const MissionConfig& config);

}  // namespace citrine

#include "modules/runtime/module_id.h"

namespace citrine {

std::string ToText(const ModuleId& id) {
  return id.uav == 0 ? id.name : id.name + " (UAV " + std::to_string(id.uav) + ")";
}

std::string ToText(const std::vector<ModuleId>& ids) {
  std::string text;
  for (const ModuleId& id : ids) text += (text.empty() ? "" : ", ") + ToText(id);
  return text;
}

std::vector<ModuleId> ModulesOf(const MissionConfig& config) {
  std::vector<ModuleId> modules = {{"uav_dynamics", 0}, {"lidar_emulator", 0}, {"map_fusion", 0}};
  for (const char* name : {"view_planner", "trajectory_smoother"})
    for (int uav = 1; uav <= config.mission.uavs; ++uav) modules.push_back({name, uav});
  modules.push_back({"topdown_renderer", 0});
  return modules;
}

std::string MissionId(const MissionConfig& config) {
  return config.mission.name + "-" + config.planner.strategy + "-" + std::to_string(config.mission.seed);
}

}  // namespace citrine

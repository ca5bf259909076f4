#include "modules/launch/process_list.h"

#include <filesystem>

namespace citrine {
namespace {

/// Modules stand beside this program.
std::string Program(const std::string& name) {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / name;
}

}  // namespace

ProcessSpec RecorderProcess(const std::string& url, const std::string& log) {
  return {kRecorder,
          {"lcm-logger", "--lcm-url=" + url, "-q", "-f", "-v", "-c", "LCM_SELF_TEST|BUS_PROBE", log}};
}

std::vector<ProcessSpec> ModuleProcesses(const MissionConfig& config, const std::string& mission_file,
                                         const std::string& url) {
  std::vector<ProcessSpec> processes;
  const auto add = [&](const std::string& module) {
    processes.push_back({module, {Program(module), "--lcm-url", url, "--mission", mission_file}});
  };
  const auto add_for_each_uav = [&](const std::string& module) {
    for (int uav = 1; uav <= config.mission.uavs; ++uav)
      processes.push_back(
          {module + std::to_string(uav),
           {Program(module), "--lcm-url", url, "--mission", mission_file, "--uav", std::to_string(uav)}});
  };
  add("lidar_emulator");
  add("map_fusion");
  add_for_each_uav("view_planner");
  add_for_each_uav("trajectory_smoother");
  add("topdown_renderer");
  add(kTimeOwner);
  return processes;
}

}  // namespace citrine

#include "modules/launch/process_list.h"

#include <algorithm>
#include <filesystem>

#include "core/config/number_text.h"
#include "modules/runtime/module_id.h"

namespace citrine {
namespace {

/// Modules stand beside this program.
std::string Program(const std::string& name) {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / name;
}

}  // namespace

ProcessSpec RecorderProcess(const std::string& url, const std::string& log, const LogSplit& split) {
  return {
      kRecorder,
      {Program(kRecorder), "--lcm-url", url, "--split-mb",
       NumberText(static_cast<double>(split.part_bytes) / 1e6), "--keep", std::to_string(split.keep), log}};
}

std::vector<ProcessSpec> ModuleProcesses(const MissionConfig& config, const std::string& mission_file,
                                         const std::string& url) {
  std::vector<ProcessSpec> processes;
  for (const ModuleId& module : ModulesOf(config)) {
    ProcessSpec process{module.name, {Program(module.name), "--lcm-url", url, "--mission", mission_file}};
    if (module.uav > 0) {
      process.name += std::to_string(module.uav);
      process.arguments.insert(process.arguments.end(), {"--uav", std::to_string(module.uav)});
    }
    processes.push_back(process);
  }
  std::stable_partition(processes.begin(), processes.end(),
                        [](const ProcessSpec& process) { return process.name != kTimeOwner; });
  return processes;
}

}  // namespace citrine

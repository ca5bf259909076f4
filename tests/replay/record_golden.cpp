// Flies the golden missions anew and replaces their recordings: after a change that is meant to change what
// modules say.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>

#include "core/config/config_file.h"
#include "modules/channels.h"
#include "modules/launch/mission_resolver.h"
#include "modules/launch/module_list.h"
#include "modules/runtime/in_process.h"
#include "modules/runtime/log_writer.h"
#include "tests/replay/golden_missions.h"
#include "tests/replay/processor_kind.h"

namespace citrine::test {
namespace {

namespace fs = std::filesystem;

/// What replays need: neither wall times nor what only counts.
bool IsKept(const LogEvent& event) {
  return event.channel != channels::kModuleHealth.name && event.channel != channels::kStepDone.name;
}

/// The mission as its log tells it: without a path of this machine.
MissionConfigText Portable(ResolvedMission mission) {
  mission.config.mission.world = fs::relative(mission.config.mission.world, CITRINE_SOURCE_DIR);
  mission.config.launch.out.clear();
  mission.flown.toml = ToToml(mission.config);
  mission.flown.overrides.clear();
  return mission.flown;
}

void Record(const GoldenMission& golden) {
  RunOptions options;
  options.mission = std::string(CITRINE_SOURCE_DIR) + "/missions/smoke.toml";
  options.overrides = golden.overrides;
  options.overrides.emplace_back("launch.in_process=true");
  ResolvedMission mission = ResolveMission(options);
  const fs::path folder = GoldenFolder(golden.name);
  fs::create_directories(folder);
  LogWriter log(folder / "mission.lcmlog");
  InProcessCallbacks callbacks;
  callbacks.on_event = [&](const LogEvent& event) {
    if (IsKept(event)) log.Write(event);
  };
  callbacks.say_first = [&](Bus& bus) { bus.Publish(channels::kMissionConfig, Encode(Portable(mission))); };
  const fs::path scratch = fs::temp_directory_path() / "citrine-record-golden";
  fs::create_directories(scratch);
  mission.config.launch.out = scratch;
  const InProcessResult result = RunInProcess(mission.config, ModuleList(), callbacks);
  log.Flush();
  fs::copy_file(scratch / "topdown.png", folder / "topdown.png", fs::copy_options::overwrite_existing);
  fs::remove_all(scratch);
  if (!result.error.empty()) throw std::runtime_error(golden.name + ": " + result.error);
  std::printf("%s: %s after %.1f s, %.1f MB\n", golden.name.c_str(), result.stop_reason.c_str(),
              Seconds(result.mission_time),
              static_cast<double>(fs::file_size(folder / "mission.lcmlog")) / 1e6);
}

}  // namespace
}  // namespace citrine::test

int main() try {
  for (const auto& golden : citrine::test::GoldenMissions()) citrine::test::Record(golden);
  std::ofstream(citrine::test::GoldenFolder("processor.txt")) << citrine::test::ProcessorKind() << "\n";
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "record_golden: %s\n", error.what());
  return 1;
}

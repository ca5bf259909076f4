#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include "core/config/config_file.h"
#include "modules/launch/commands.h"
#include "modules/launch/flight.h"
#include "modules/launch/interrupts.h"
#include "modules/launch/mission_file.h"
#include "modules/launch/network_choice.h"
#include "modules/launch/result_folder.h"
#include "modules/launch/results_table.h"
#include "modules/launch/running_mission.h"
#include "modules/mission_report/mission_report.h"
#include "viz/display.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

/// What can be observed of a world is found once.
std::string CacheFolder() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache) return fs::path(cache) / "citrine";
  if (const char* home = std::getenv("HOME"); home && *home) return fs::path(home) / ".cache" / "citrine";
  return {};
}

bool WantsOneProcess(const RunOptions& options) {
  return ParseMission(ReadMissionFile(options.mission).toml, options.overrides).launch.in_process;
}

void RequireDisplay() {
  if (const std::string why = viz::WhyNoDisplay(); !why.empty())
    throw std::runtime_error("no window for --view: " + why + "; --video needs none\n  mend: " + kDisplay);
}

ExitCode ExitCodeOf(const Flight& flight, const logs::Metrics& metrics) {
  if (flight.stop_reason == "interrupted") return kInterrupted;
  if (flight.death) return kModuleDied;
  return metrics.completed && metrics.collisions.value_or(0) == 0 ? kCompleted : kNotCompleted;
}

logs::Metrics ReportOn(const ResolvedMission& mission, const Flight& flight) {
  ReportInputs inputs;
  inputs.config = mission.config;
  inputs.log_path = fs::path(mission.config.launch.out) / "mission.lcmlog";
  inputs.stop_reason = flight.stop_reason;
  inputs.wall_time_s = flight.wall_time_s;
  inputs.in_process = mission.config.launch.in_process;
  inputs.pace = mission.config.launch.pace;
  inputs.commit = mission.flown.commit + (mission.flown.dirty ? "-dirty" : "");
  inputs.cache_folder = CacheFolder();
  return WriteReport(mission.config.launch.out, inputs);
}

}  // namespace

int RunMission(const RunOptions& asked) {
  CountInterrupts();
  RunOptions options = asked;
  std::optional<std::string> bus;
  if (!WantsOneProcess(options)) {
    bus = ChooseBus(options.isolate);
    if (!bus && options.by_hand) throw std::runtime_error("without a bus no module can be started by hand");
    if (!bus) options.overrides.emplace_back("launch.in_process=true");
  }
  const ResolvedMission mission = ResolveMission(options);
  if (mission.config.launch.view && !options.by_hand) RequireDisplay();
  fs::create_directories(mission.config.launch.out);
  std::optional<RunningMission> running(std::in_place, mission.config.launch.out, bus.value_or("memq://"));
  const std::string file = PrepareResultFolder(mission);
  std::fprintf(stderr, "citrine: %s, %d UAVs; results in %s\n", mission.flown.mission_id.c_str(),
               mission.config.mission.uavs, mission.config.launch.out.c_str());
  const Flight flight = bus ? FlyInProcesses(mission, file, *bus, options.by_hand) : FlyInProcess(mission);
  running.reset();
  std::fprintf(stderr, "citrine: %s; writing the report\n", flight.stop_reason.c_str());
  const logs::Metrics metrics = ReportOn(mission, flight);
  std::fputs(ResultsTable(metrics, mission.config.launch.out).c_str(), stdout);
  return ExitCodeOf(flight, metrics);
}

}  // namespace citrine

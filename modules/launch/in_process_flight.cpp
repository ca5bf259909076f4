#include <cstdio>
#include <filesystem>

#include "modules/channels.h"
#include "modules/launch/flight.h"
#include "modules/launch/interrupts.h"
#include "modules/launch/mission_view.h"
#include "modules/launch/module_list.h"
#include "modules/launch/progress_line.h"
#include "modules/launch/result_folder.h"
#include "modules/runtime/in_process.h"
#include "modules/runtime/log_writer.h"
#include "modules/runtime/stopwatch.h"

namespace citrine {

Flight FlyInProcess(const ResolvedMission& mission) {
  LogWriter log(std::filesystem::path(mission.config.launch.out) / "mission.lcmlog",
                SplitOf(mission.config.launch));
  ProgressLine progress(stderr);
  MissionView view;
  view.mission_id = mission.flown.mission_id;
  view.uavs.resize(static_cast<std::size_t>(mission.config.mission.uavs));
  InProcessCallbacks callbacks;
  callbacks.on_event = [&](const LogEvent& event) {
    log.Write(event);
    view.Hear(event.channel, event.bytes.data(), static_cast<int>(event.bytes.size()));
  };
  callbacks.interrupted = [&] {
    progress.Show(view);
    return Interrupts() > 0;
  };
  callbacks.say_first = [&](Bus& bus) { bus.Publish(channels::kMissionConfig, Encode(mission.flown)); };

  const Stopwatch stopwatch;
  const InProcessResult result = RunInProcess(mission.config, ModuleList(), callbacks, mission.world);
  log.Flush();
  progress.Finish();
  Flight flight{result.stop_reason, stopwatch.ms() / 1e3, std::nullopt};
  if (!result.error.empty()) {
    flight.death = result.error;
    std::fprintf(stderr, "citrine: %s\n", result.error.c_str());
  }
  return flight;
}

}  // namespace citrine

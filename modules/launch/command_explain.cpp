#include <cstdio>
#include <filesystem>

#include "modules/explain/explain.h"
#include "modules/launch/commands.h"
#include "modules/launch/interrupts.h"
#include "modules/replay/recorded_mission.h"
#include "viz/frame_writer.h"

namespace citrine {

namespace fs = std::filesystem;

int ExplainDecision(const ExplainOptions& options) {
  CountInterrupts();
  const fs::path log = FindLog(options.run);
  const RecordedMission mission = ReadMission(log);
  const int uavs = mission.config.mission.uavs;
  if (options.uav < 1 || options.uav > uavs) {
    std::fprintf(stderr, "citrine: --uav %d: the recording has UAVs 1 to %d\n", options.uav, uavs);
    return kWrongUse;
  }
  std::fprintf(stderr, "citrine: feeding %s into the planner of UAV %d\n", log.c_str(), options.uav);
  const Explanation explanation =
      Explain(mission, options.uav, options.decision, options.rows, [] { return Interrupts() > 0; });
  if (Interrupts() > 0) return kInterrupted;
  if (!explanation.found) {
    std::fprintf(stderr, "citrine: --decision %lld: UAV %d made %lld\n",
                 static_cast<long long>(options.decision), options.uav,
                 static_cast<long long>(explanation.decisions));
    return kWrongUse;
  }
  std::fputs(explanation.text.c_str(), stdout);
  const fs::path picture = !options.out.empty()
                               ? fs::path(options.out)
                               : log.parent_path() / ("explain-uav" + std::to_string(options.uav) + "-" +
                                                      std::to_string(options.decision) + ".png");
  viz::WritePng(picture, explanation.picture);
  std::printf("%s\n", picture.c_str());
  if (explanation.as_recorded) return kCompleted;
  std::fprintf(
      stderr,
      "citrine: the recording flew elsewhere: it was made by another build or on another processor\n");
  return kNotCompleted;
}

}  // namespace citrine

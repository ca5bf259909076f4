#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <stdexcept>

#include <unistd.h>

#include "modules/launch/bus_checks.h"
#include "modules/launch/commands.h"
#include "modules/launch/interrupts.h"
#include "modules/launch/mission_view.h"
#include "modules/launch/module_list.h"
#include "modules/launch/progress_line.h"
#include "modules/replay/comparison.h"
#include "modules/replay/play.h"
#include "modules/replay/recorded_mission.h"
#include "modules/replay/replay.h"
#include "modules/replay/said_by.h"
#include "viz/frame_writer.h"
#include "viz/read_png.h"

namespace citrine {
namespace {

namespace fs = std::filesystem;

constexpr double kListen_s = 0.5;

void SayFlaws(const RecordingFlaws& flaws) {
  if (flaws.damaged > 0)
    std::fprintf(stderr, "citrine: %lld damaged places of the log were skipped\n",
                 static_cast<long long>(flaws.damaged));
  if (flaws.missing > 0)
    std::fprintf(stderr, "citrine: %lld messages are missing in the log; what needs them will differ\n",
                 static_cast<long long>(flaws.missing));
}

int PlayOnBus(const RecordedMission& mission, double speed) {
  const std::string url = DefaultBusUrl();
  const BusCheck bus = CheckBus(url, kListen_s);
  if (const std::string why = WhyUnheard(bus, url); !why.empty()) throw std::runtime_error(why);
  if (!bus.other_mission.empty())
    throw std::runtime_error("another mission, " + bus.other_mission + ", is on the bus " + url +
                             ".\n  mend: wait for its end, or " + kAnotherPort);
  Transport transport(url);
  ProgressLine progress(stderr);
  MissionView view;
  view.mission_id = mission.flown.mission_id;
  view.uavs.resize(static_cast<std::size_t>(mission.config.mission.uavs));
  Play(mission.events, transport, speed, [&](const LogEvent& event) {
    view.Hear(event.channel, event.bytes.data(), static_cast<int>(event.bytes.size()));
    progress.Show(view);
    return Interrupts() == 0;
  });
  progress.Finish();
  return Interrupts() > 0 ? kInterrupted : kCompleted;
}

/// @return whether the module said what was recorded
bool ReplayInto(const ModuleKind& kind, int uav, const RecordedMission& mission, const MissionConfig& config,
                double speed) {
  const ModuleId id{kind.name, uav};
  const Replayed replayed = Replay(mission.events, config, kind, uav, speed, [] { return Interrupts() > 0; });
  if (!replayed.error.empty()) throw std::runtime_error(replayed.error);
  std::vector<LogEvent> recorded;
  std::copy_if(mission.events.begin(), mission.events.end(), std::back_inserter(recorded),
               [&](const LogEvent& event) { return SaidBy(id, event); });
  const bool lockstep = mission.config.lockstep();
  const Comparison comparison = Compare(recorded, replayed.said, lockstep ? kIdentical : kPaced);
  const auto name = ToText(id);
  if (comparison.recorded == 0 && comparison.said == 0) return true;
  if (comparison.different == 0) {
    std::printf("%s: %lld messages, %s\n", name.c_str(), static_cast<long long>(comparison.said),
                lockstep ? "all identical to the recording" : "all as recorded, within tolerance");
    return true;
  }
  std::printf("%s: %lld of %lld messages differ from the recording; the first:\n  %s\n", name.c_str(),
              static_cast<long long>(comparison.different), static_cast<long long>(comparison.recorded),
              comparison.first->Text().c_str());
  return false;
}

/// The renderer says nothing: what it draws is held against the picture beside the log.
bool ComparePicture(const fs::path& drawn, const fs::path& recorded) {
  if (!fs::exists(recorded)) {
    std::printf("topdown_renderer: %s is not there to compare with\n", recorded.c_str());
    return true;
  }
  const viz::PixelDifference difference = viz::ComparePngs(drawn, recorded);
  if (difference.pixels == 0) {
    std::printf("topdown_renderer: topdown.png is identical to the recording's\n");
    return true;
  }
  std::printf(
      "topdown_renderer: %lld pixels of topdown.png differ from the recording's, the first at (%d, %d)\n",
      static_cast<long long>(difference.pixels), difference.x, difference.y);
  return false;
}

/// @param beside where the recording's own results are
int ReplayInto(const ModuleKind& kind, const RecordedMission& mission, const fs::path& beside,
               const ReplayOptions& options) {
  MissionConfig config = mission.config;
  const bool draws = kind.name == "topdown_renderer";
  const fs::path scratch = fs::temp_directory_path() / ("citrine-replay-" + std::to_string(getpid()));
  const fs::path out = options.out.empty() ? scratch : fs::path(options.out);
  config.launch.out = draws ? out.string() : "";
  config.launch.view = options.view;
  config.launch.video = options.video;
  if (draws) fs::create_directories(out);
  bool same = true;
  for (int uav = kind.per_uav ? 1 : 0; uav <= (kind.per_uav ? config.mission.uavs : 0); ++uav)
    same &= ReplayInto(kind, uav, mission, config, options.speed);
  if (draws) same &= ComparePicture(out / "topdown.png", beside / "topdown.png");
  if (draws && options.out.empty()) fs::remove_all(scratch);
  if (Interrupts() > 0) return kInterrupted;
  return same ? kCompleted : kNotCompleted;
}

}  // namespace

int ReplayLog(const ReplayOptions& options) {
  CountInterrupts();
  const std::string log = FindLog(options.log);
  const RecordedMission mission = ReadMission(log);
  SayFlaws(mission.flaws);
  if (options.into.empty()) return PlayOnBus(mission, options.speed > 0 ? options.speed : 1);
  const std::vector<ModuleKind> kinds = ModuleList();
  const auto kind = std::find_if(kinds.begin(), kinds.end(),
                                 [&](const ModuleKind& each) { return each.name == options.into; });
  return ReplayInto(*kind, mission, fs::absolute(log).parent_path(), options);
}

}  // namespace citrine

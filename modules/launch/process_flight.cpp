#include <algorithm>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>

#include "modules/channels.h"
#include "modules/launch/flight.h"
#include "modules/launch/interrupts.h"
#include "modules/launch/mission_view.h"
#include "modules/launch/process_list.h"
#include "modules/launch/progress_line.h"
#include "modules/launch/result_folder.h"
#include "modules/launch/supervisor.h"
#include "modules/runtime/log_reader.h"
#include "modules/runtime/stopwatch.h"

namespace citrine {
namespace {

constexpr int kLook_ms = 50;
constexpr double kConfigPeriod_s = 5;  ///< of MISSION_CONFIG, in mission time
constexpr int kLastWords = 8;
constexpr double kRecorderReady_s = 5;  ///< the recorder's own test of the bus is heard sooner than that
constexpr double kReplyToInterrupt_s = 20;
constexpr double kWriteResults_s = 120;  ///< a mesh of a large world takes its time
constexpr double kObey_s = 5;
constexpr double kSilence_s = 5;    ///< of the wall, without MODULE_HEALTH, before a module is named
constexpr double kFarewell_s = 30;  ///< in which modules that were started by hand have written their results

/// As a shell takes it for one word; what lies below this folder by the shorter way.
std::string Quoted(const std::string& word) {
  const std::string here = std::filesystem::current_path().string() + "/";
  const std::string typed = word.starts_with(here) ? word.substr(here.size()) : word;
  return typed.find_first_of(" &'?*()") == std::string::npos ? typed : "'" + typed + "'";
}

/// What one types to start a process; the default bus goes without saying.
std::string CommandLine(const ProcessSpec& process) {
  std::string line;
  for (std::size_t i = 0; i < process.arguments.size(); ++i) {
    if (process.arguments[i] == "--lcm-url" && process.arguments.at(i + 1) == DefaultBusUrl())
      ++i;
    else
      line += " " + Quoted(process.arguments[i]);
  }
  return line;
}

/// The mission's processes, from their start until the last of them has left.
class ProcessFlight {
 public:
  ProcessFlight(const ResolvedMission& mission, const std::string& logs_folder, const std::string& url,
                bool by_hand)
      : flown_(mission.flown), by_hand_(by_hand), supervisor_(logs_folder), bus_(url), progress_(stderr) {
    view_.mission_id = mission.flown.mission_id;
    view_.uavs.resize(static_cast<std::size_t>(mission.config.mission.uavs));
    bus_.HearBytes(MissionView::kChannels, [this](const std::string& channel, const void* bytes, int size) {
      view_.Hear(channel, bytes, size);
    });
    bus_.HearBytes(channels::kModuleHealth.name,
                   [this](const std::string&, const void* bytes, int size) { HearHealth(bytes, size); });
  }

  void StartRecorder(const ProcessSpec& recorder) {
    bool ready = false;
    bus_.HearBytes("LCM_SELF_TEST", [&ready](const std::string&, const void*, int) { ready = true; });
    supervisor_.Start(recorder);
    for (const Stopwatch since; !ready && since.ms() < kRecorderReady_s * 1e3;) Look();
    if (!ready)
      throw std::runtime_error("the recorder does not start: " +
                               supervisor_.LastWords(kRecorder, kLastWords));
  }

  void Start(const std::vector<ProcessSpec>& modules) {
    for (const ProcessSpec& module : modules) supervisor_.Start(module);
  }

  /// Says how each module is started, and waits for those who do not end with the mission's last step.
  void LetOthersStart(const std::vector<ProcessSpec>& modules) {
    std::string text =
        "citrine: recording. Start each of these in a terminal of its own, in any order; one that ends can "
        "be "
        "started again:\n";
    for (const ProcessSpec& module : modules) {
      waited_for_.insert(module.name);
      text += " " + CommandLine(module) + "\n";
    }
    std::fputs(text.c_str(), stderr);
  }

  /// Looks on until the mission is over.
  void Watch() {
    bool told = false;
    Stopwatch since_told;
    while (!view_.done() && !death_ && (by_hand_ || supervisor_.runs(kTimeOwner))) {
      Look();
      progress_.Show(view_);
      NoteDepartures();
      NoteSilence();
      if (by_hand_ && Interrupts() > 0) return;
      if (Interrupts() > 1) return supervisor_.SignalAllBut(kRecorder, SIGKILL);
      if (Interrupts() > 0 && !told) {
        told = true;
        since_told = Stopwatch();
        supervisor_.Signal(kTimeOwner, SIGINT);
      }
      if (told && since_told.ms() > kReplyToInterrupt_s * 1e3) return;
    }
  }

  /// Lets everybody write what is to be written; then the recorder closes the log.
  void WindDown() {
    for (const Stopwatch since; by_hand_ && view_.done() && !waited_for_.empty() && Interrupts() == 0 &&
                                since.ms() < kFarewell_s * 1e3;)
      Look();
    if (!supervisor_.runs(kTimeOwner) && !view_.done())
      supervisor_.SignalAllBut(kRecorder, SIGTERM);  // nobody will tell them that the mission is over
    else if (death_)
      supervisor_.Signal(kTimeOwner, SIGINT);
    if (death_ && Wait(kWriteResults_s, {kTimeOwner, kRecorder}))
      supervisor_.Signal(kTimeOwner, SIGTERM);  // it would wait for the dead
    if (!Wait(kWriteResults_s, {kRecorder})) supervisor_.SignalAllBut(kRecorder, SIGTERM);
    if (!Wait(kObey_s, {kRecorder})) supervisor_.SignalAllBut(kRecorder, SIGKILL);
    supervisor_.Signal(kRecorder, SIGTERM);
    Wait(kObey_s, {});
    progress_.Finish();
  }

  /// Names who missed most, if anybody missed anything.
  void SayLosses() const {
    std::int64_t all = 0;
    for (const auto& [name, lost] : lost_) all += lost;
    if (all == 0) return;
    const auto most = std::max_element(lost_.begin(), lost_.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    std::fprintf(
        stderr,
        "citrine: bus: %lld messages were lost, %lld of them at %s: a slow host or a small buffer, see "
        "./citrine doctor\n",
        static_cast<long long>(all), static_cast<long long>(most->second), most->first.c_str());
  }

  std::string StopReason() const {
    if (death_) return "module_died";
    if (Interrupts() > 0) return "interrupted";
    return view_.done() ? view_.clock->reason : "module_died";
  }
  const std::optional<std::string>& death() const { return death_; }

 private:
  /// Takes over what is said, and says what is flown.
  void Look() {
    bus_.Handle(kLook_ms);
    if (!view_.clock || !say_config_.Due(view_.clock->utime)) return;
    bus_.BeginStep({view_.clock->step, view_.clock->utime, view_.done()}, false);
    bus_.Publish(channels::kMissionConfig, Encode(flown_));
  }

  /// Waits until nobody but `staying` runs. @return false if that takes longer than `most_s`
  bool Wait(double most_s, const std::set<std::string>& staying) {
    const auto others_run = [&] {
      const std::vector<std::string> running = supervisor_.running();
      return std::any_of(running.begin(), running.end(),
                         [&](const auto& name) { return !staying.contains(name); });
    };
    for (const Stopwatch since; others_run() && since.ms() < most_s * 1e3;) {
      Look();
      NoteDepartures();
      if (Interrupts() > 1) supervisor_.SignalAllBut(kRecorder, SIGKILL);
    }
    return !others_run();
  }

  /// Whoever leaves in order after the end leaves as it should; anybody else has died.
  void NoteDepartures() {
    for (const Departure& departure : supervisor_.TakeDepartures()) {
      if (departure.orderly() && (view_.done() || departure.name == kTimeOwner)) continue;
      if (departure.name == kRecorder && (view_.done() || death_)) continue;
      if (death_ || Interrupts() > 0) continue;
      death_ = departure.name + " " + departure.how();
      progress_.Finish();
      std::fprintf(stderr, "citrine: %s; log: %s; its last lines:\n%s", death_->c_str(),
                   supervisor_.LogFile(departure.name).c_str(),
                   supervisor_.LastWords(departure.name, kLastWords).c_str());
    }
  }

  void HearHealth(const void* bytes, int size) {
    citrine_lcm::module_health_t health{};
    try {
      if (health.decode(bytes, 0, size) != size) return;
    } catch (const std::exception&) {
      return;  // whoever it was has not answered
    }
    const std::string name = health.module + (health.uav > 0 ? std::to_string(health.uav) : "");
    if (health.state == citrine_lcm::module_health_t::DONE && view_.done()) waited_for_.erase(name);
    lost_[name] = health.messages_lost;
    answered_[name] = Stopwatch();
    silent_.erase(name);
  }

  /// Names once who is alive and does not answer.
  void NoteSilence() {
    for (const auto& [name, since] : answered_) {
      if (since.ms() < kSilence_s * 1e3 || !silent_.insert(name).second) continue;
      progress_.Finish();
      std::fprintf(
          stderr,
          "citrine: %s has not answered for %.0f s of wall time; waiting; Ctrl-C ends the mission with its "
          "results\n",
          name.c_str(), kSilence_s);
    }
  }

  MissionConfigText flown_;
  bool by_hand_;
  std::set<std::string>
      waited_for_;  ///< modules that are started by hand and have not said that they are done
  std::map<std::string, Stopwatch> answered_;  ///< when each module was last heard
  std::map<std::string, std::int64_t> lost_;   ///< messages that each module has missed so far
  std::set<std::string> silent_;               ///< of them, those that have been named
  Supervisor supervisor_;
  Bus bus_;
  Every say_config_{kConfigPeriod_s};
  MissionView view_;
  ProgressLine progress_;
  std::optional<std::string> death_;
};

}  // namespace

Flight FlyInProcesses(const ResolvedMission& mission, const std::string& mission_file, const std::string& url,
                      bool by_hand) {
  const std::filesystem::path out = mission.config.launch.out;
  const std::filesystem::path logs = out / "logs", recorded = out / "recorded.lcmlog";
  std::filesystem::create_directories(logs);
  const Stopwatch stopwatch;
  const LogSplit split = SplitOf(mission.config.launch);
  Flight flight;
  {
    ProcessFlight processes(mission, logs, url, by_hand);
    processes.StartRecorder(RecorderProcess(url, recorded, split));
    const std::vector<ProcessSpec> modules = ModuleProcesses(mission.config, mission_file, url);
    if (by_hand)
      processes.LetOthersStart(modules);
    else
      processes.Start(modules);
    processes.Watch();
    flight.wall_time_s = stopwatch.ms() / 1e3;
    processes.WindDown();
    processes.SayLosses();
    flight.stop_reason = processes.StopReason();
    flight.death = processes.death();
  }
  PutInOrder(recorded, out / "mission.lcmlog", nullptr, split);
  for (const std::string& file : LogFiles(recorded)) std::filesystem::remove(file);
  return flight;
}

}  // namespace citrine

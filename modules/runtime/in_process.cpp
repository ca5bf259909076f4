#include "modules/runtime/in_process.h"

#include <algorithm>
#include <chrono>
#include <deque>
#include <stdexcept>
#include <thread>

#include "modules/runtime/clock_owner.h"
#include "modules/runtime/hosted_module.h"
#include "modules/runtime/wall_pacer.h"

namespace citrine {
namespace {

/// Gathers what is said in a step and hands it on in canonical order.
class Recorder {
 public:
  Recorder(std::shared_ptr<Transport> transport, std::function<void(const LogEvent&)> on_event)
      : bus_(std::move(transport)), on_event_(std::move(on_event)) {
    if (on_event_)
      bus_.HearBytes(".*", [this](const std::string& channel, const void* bytes, int size) {
        const auto* first = static_cast<const std::uint8_t*>(bytes);
        events_.push_back({0, channel, {first, first + size}});
        events_.back().time = events_.back().utime();
      });
  }
  void EndStep() {
    std::sort(events_.begin(), events_.end());
    for (const LogEvent& event : events_) on_event_(event);
    events_.clear();
  }

 private:
  Bus bus_;
  std::function<void(const LogEvent&)> on_event_;
  std::vector<LogEvent> events_;
};

/// The modules of a mission on one transport; those that need the map share what hears it.
class Crew {
 public:
  Crew(const MissionConfig& config, const std::vector<ModuleKind>& kinds,
       const std::shared_ptr<Transport>& transport, const std::shared_ptr<const sim::World>& world)
      : map_bus_(transport) {
    for (const ModuleKind& kind : kinds)
      if (kind.make_map_hearer && !map_hearer_) map_hearer_ = kind.make_map_hearer(config, map_bus_);
    for (const ModuleKind& kind : kinds) {
      const int count = kind.per_uav ? config.mission.uavs : 1;
      for (int i = 1; i <= count; ++i) {
        modules_.emplace_back(kind, config, kind.per_uav ? i : 0, transport, map_hearer_, world);
        if (!kind.owns_time()) continue;
        if (owner_) throw std::invalid_argument("several modules own the time: " + kind.name);
        owner_ = &modules_.back();
      }
    }
    if (!owner_) throw std::invalid_argument("no module owns the time");
  }

  HostedModule& owner() { return *owner_; }
  void Begin(const Step& step) {
    map_bus_.BeginStep(step, true);
    for (HostedModule& module : modules_) module.Begin(step, true);
  }
  /// @return what made a module die; empty if all live
  std::string Tick(const Step& step) {
    std::string error;
    for (HostedModule& module : modules_) {
      try {
        module.Tick(step);
        module.SayStepDone(step);
        module.SayHealthWhenDue();
      } catch (const std::exception& e) {
        error = ToText(module.id()) + ": " + e.what();
      }
    }
    return error;
  }
  void SayHealth(ModuleHealth::State state) {
    for (HostedModule& module : modules_) module.SayHealth(state);
  }

 private:
  Bus map_bus_;
  std::shared_ptr<MapHearer> map_hearer_;
  std::deque<HostedModule> modules_;
  HostedModule* owner_ = nullptr;
};

}  // namespace

InProcessResult RunInProcess(const MissionConfig& config, const std::vector<ModuleKind>& kinds,
                             const InProcessCallbacks& callbacks,
                             const std::shared_ptr<const sim::World>& world) {
  const auto transport = std::make_shared<Transport>("memq://");
  Recorder recorder(transport, callbacks.on_event);
  Bus own(transport);
  Crew crew(config, kinds, transport, world);
  ClockOwner clock(config, crew.owner().bus());
  WallPacer pacer(config.launch.pace, config.dynamics.step_s);
  if (callbacks.say_first) callbacks.say_first(own);

  InProcessResult result;
  for (std::optional<std::string> reason;;) {
    transport->Handle(0);
    if (result.steps > 0) recorder.EndStep();
    const Step step = clock.Advance(reason, true);
    crew.Begin(step);
    const std::string error = crew.Tick(step);
    if (result.error.empty()) result.error = error;
    ++result.steps;
    result.mission_time = step.now;
    if (step.last) break;
    if (!result.error.empty())
      reason = "module_died";
    else if (callbacks.interrupted && callbacks.interrupted())
      reason = "interrupted";
    else
      reason = crew.owner().stop_reason();
    if (reason) result.stop_reason = *reason;
    pacer.EndStep();
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(pacer.left_ms()));
  }
  crew.SayHealth(ModuleHealth::State::kDone);
  transport->Handle(0);
  recorder.EndStep();
  return result;
}

}  // namespace citrine

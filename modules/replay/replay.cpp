#include "modules/replay/replay.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <thread>

#include "modules/channels.h"
#include "modules/codec/clock.h"
#include "modules/replay/said_by.h"
#include "modules/runtime/hosted_module.h"
#include "modules/runtime/wall_pacer.h"

namespace citrine {
namespace {

/// The steps that a recording knows of, in order.
std::vector<Step> StepsOf(const std::vector<LogEvent>& events) {
  std::vector<Step> steps;
  for (const LogEvent& event : events) {
    if (event.channel != channels::kClock.name) continue;
    citrine_lcm::clock_t message{};
    try {
      if (message.decode(event.bytes.data(), 0, static_cast<int>(event.bytes.size())) < 0) continue;
      const Clock clock = Decode(message);
      steps.push_back({clock.step, clock.utime, clock.state == Clock::State::kDone});
    } catch (const std::exception&) {  // a damaged step is one that nobody took
    }
  }
  return steps;
}

/// Keeps what a module says.
class Stenographer {
 public:
  Stenographer(const ModuleId& module, const std::shared_ptr<Transport>& transport) : bus_(transport) {
    bus_.HearBytes(".*", [this, module](const std::string& channel, const void* bytes, int size) {
      const auto* first = static_cast<const std::uint8_t*>(bytes);
      LogEvent event{0, channel, {first, first + size}};
      event.time = event.utime();
      if (SaidBy(module, event)) said_.push_back(std::move(event));
    });
  }
  std::vector<LogEvent> Take() {
    std::sort(said_.begin(), said_.end());
    return std::move(said_);
  }

 private:
  Bus bus_;
  std::vector<LogEvent> said_;
};

}  // namespace

Replayed Replay(const std::vector<LogEvent>& events, const MissionConfig& config, const ModuleKind& kind,
                int uav, double speed, const std::function<bool()>& interrupted) {
  const auto transport = std::make_shared<Transport>("memq://");
  HostedModule module(kind, config, uav, transport);
  Stenographer stenographer(module.id(), transport);
  WallPacer pacer(speed, config.dynamics.step_s);
  Replayed replayed;
  auto next = events.begin();
  try {
    for (const Step& step : StepsOf(events)) {
      if (interrupted && interrupted()) break;
      for (; next != events.end() && next->utime() < step.now; ++next)
        if (!SaidBy(module.id(), *next)) transport->Send(next->channel, next->bytes);
      transport->Handle(0);
      module.Begin(step, true);
      module.Tick(step);
      ++replayed.steps;
      pacer.EndStep();
      std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(pacer.left_ms()));
    }
  } catch (const std::exception& error) {
    replayed.error = ToText(module.id()) + ": " + error.what();
  }
  transport->Handle(0);
  replayed.said = stenographer.Take();
  return replayed;
}

}  // namespace citrine

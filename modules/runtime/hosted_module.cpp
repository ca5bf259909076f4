#include "modules/runtime/hosted_module.h"

#include <algorithm>

#include <sys/resource.h>

#include "modules/channels.h"
#include "modules/codec/step_done.h"

namespace citrine {
namespace {

constexpr double kHealthPeriod_ms = 1000;
constexpr double kAnnouncePeriod_ms = 200;
constexpr std::size_t kMaxSamplesAMessage = 8000;  // 4 bytes each: well under what a message may hold

std::int64_t PeakMemory_kB() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

/// Moves up to kMaxSamplesAMessage values out of `samples`.
std::map<std::string, std::vector<float>> TakeSome(std::map<std::string, std::vector<float>>& samples) {
  std::map<std::string, std::vector<float>> some;
  std::size_t room = kMaxSamplesAMessage;
  while (!samples.empty() && room > 0) {
    auto& [name, values] = *samples.begin();
    const auto last = values.begin() + static_cast<std::ptrdiff_t>(std::min(room, values.size()));
    room -= std::min(room, values.size());
    some[name].assign(values.begin(), last);
    values.erase(values.begin(), last);
    if (values.empty()) samples.erase(samples.begin());
  }
  return some;
}

}  // namespace

HostedModule::HostedModule(const ModuleKind& kind, const MissionConfig& config, int uav,
                           std::shared_ptr<Transport> transport, std::shared_ptr<MapHearer> map_hearer,
                           std::shared_ptr<const sim::World> world)
    : kind_(kind), config_(config), uav_(uav), bus_(std::move(transport)) {
  if (!kind_.make_map_hearer)
    map_hearer = nullptr;
  else if (!map_hearer)
    map_hearer = kind_.make_map_hearer(config_, bus_);
  module_ = kind_.make({config_, bus_, health_, uav_, std::move(map_hearer), std::move(world)});
}

void HostedModule::Tick(const Step& step) {
  const Stopwatch watch;
  module_->Tick(step);
  worst_tick_ms_ = std::max(worst_tick_ms_, watch.ms());
  last_tick_ = step.now;
}

std::optional<std::string> HostedModule::stop_reason() const {
  return kind_.owns_time() ? kind_.stop_reason(*module_) : std::nullopt;
}

void HostedModule::SayStepDone(const Step& step) {
  StepDone done{step.index, kind_.name, uav_, {}};
  for (const auto& [channel, seq] : bus_.last_said()) {
    if (channel == channels::kStepDone.name || channel == channels::kModuleHealth.name) continue;
    if (std::int64_t& before = said_before_[channel]; before != seq) done.last_seq[channel] = before = seq;
  }
  citrine_lcm::step_done_t message = Encode(done);
  bus_.Publish(channels::kStepDone, message);
  message.utime = bus_.now();
  message.seq = bus_.last_said().at(channels::kStepDone.name);
  step_done_ = Bus::ToBytes(message);
}

void HostedModule::RepeatStepDone() { bus_.SayBytes(channels::kStepDone.name, step_done_); }

void HostedModule::SayHealth(ModuleHealth::State state) {
  const BusCounts& counts = bus_.counts();
  ModuleHealth health{kind_.name,
                      uav_,
                      state,
                      last_tick_,
                      worst_tick_ms_,
                      counts.lost,
                      counts.bad,
                      counts.bytes_said,
                      PeakMemory_kB(),
                      health_.last_error().empty() ? counts.last_bad : health_.last_error(),
                      {}};
  auto samples = health_.TakeSamples();
  do {
    health.samples = TakeSome(samples);
    bus_.Publish(channels::kModuleHealth, Encode(health));
  } while (!samples.empty());
  worst_tick_ms_ = 0;
  since_health_ = {};
}

void HostedModule::SayHealthWhenDue(ModuleHealth::State state) {
  const bool starting = state == ModuleHealth::State::kStarting;
  if (since_health_.ms() >= (starting ? kAnnouncePeriod_ms : kHealthPeriod_ms)) SayHealth(state);
}

}  // namespace citrine

#pragma once

#include <memory>
#include <optional>
#include <string>

#include "modules/codec/module_health.h"
#include "modules/runtime/module_id.h"
#include "modules/runtime/module_kind.h"
#include "modules/runtime/stopwatch.h"

namespace citrine {

/// A module with its own bus and health, and the manners that all modules share: STEP_DONE and MODULE_HEALTH.
class HostedModule {
 public:
  /// @param map_hearer one that modules of this process share; null: made on the module's own bus if it needs
  /// one
  /// @param world  likewise; null: read by the module
  HostedModule(const ModuleKind& kind, const MissionConfig& config, int uav,
               std::shared_ptr<Transport> transport, std::shared_ptr<MapHearer> map_hearer = nullptr,
               std::shared_ptr<const sim::World> world = nullptr);

  ModuleId id() const { return {kind_.name, uav_}; }
  Bus& bus() { return bus_; }
  Health& health() { return health_; }
  const MissionConfig& config() const { return config_; }

  /// Lets the inboxes offer what is due.
  void Begin(const Step& step, bool lockstep) { bus_.BeginStep(step, lockstep); }
  /// Ticks the module and measures how long it takes. @throws what the module throws
  void Tick(const Step& step);
  /// Why the mission is over, if this module owns the time and it is.
  std::optional<std::string> stop_reason() const;

  /// Says which messages this module has said in a step.
  void SayStepDone(const Step& step);
  /// Says the last STEP_DONE again, for an owner of time that missed it.
  void RepeatStepDone();

  /// Says MODULE_HEALTH, in as many messages as the samples need.
  void SayHealth(ModuleHealth::State state);
  /// As above if a second of the wall has passed since the last time; while it starts, five times a second.
  void SayHealthWhenDue(ModuleHealth::State state = ModuleHealth::State::kRunning);

 private:
  const ModuleKind kind_;
  const MissionConfig config_;
  const int uav_;
  Bus bus_;
  Health health_;
  std::unique_ptr<Module> module_;
  std::map<std::string, std::int64_t> said_before_;
  std::vector<std::uint8_t> step_done_;
  Utime last_tick_ = 0;
  double worst_tick_ms_ = 0;
  Stopwatch since_health_;
};

}  // namespace citrine

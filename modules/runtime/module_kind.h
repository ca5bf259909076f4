#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "modules/map_hearer.h"
#include "modules/runtime/module.h"

namespace citrine {

/// What the run loops need to know of a kind of module, without knowing the kind.
struct ModuleKind {
  std::string name;  ///< of its folder, executable, config section and health
  std::string summary;
  bool per_uav = false;  ///< one a UAV
  std::function<std::unique_ptr<Module>(const ModuleContext&)> make;
  /// Makes what the module hears the map through; empty for a module that does not.
  std::function<std::shared_ptr<MapHearer>(const MissionConfig&, Bus&)> make_map_hearer;
  /// Why the mission is over, if it is, by the module that owns the time; empty for all others.
  std::function<std::optional<std::string>(const Module&)> stop_reason;

  bool owns_time() const { return static_cast<bool>(stop_reason); }
};

/// The kind that a module class declares: kName, kSummary, kPerUav, kHearsMap, and `stop_reason()` if it owns
/// the time.
template <class M>
ModuleKind KindOf() {
  ModuleKind kind;
  kind.name = M::kName;
  kind.summary = M::kSummary;
  if constexpr (requires { M::kPerUav; }) kind.per_uav = M::kPerUav;
  kind.make = [](const ModuleContext& context) { return std::make_unique<M>(context); };
  if constexpr (M::kHearsMap)
    kind.make_map_hearer = [](const MissionConfig& config, Bus& bus) {
      return std::make_shared<MapHearer>(config, bus);
    };
  if constexpr (requires(const M& m) { m.stop_reason(); })
    kind.stop_reason = [](const Module& module) -> std::optional<std::string> {
      return static_cast<const M&>(module).stop_reason();
    };
  return kind;
}

}  // namespace citrine

#pragma once

#include <memory>

#include "core/config/mission_config.h"
#include "modules/runtime/bus.h"
#include "modules/runtime/health.h"
#include "modules/runtime/step.h"

namespace citrine {

class MapHearer;
namespace sim {
struct World;
}

/// What a module is given: its mission, the bus, its own health, and which UAV it serves.
struct ModuleContext {
  const MissionConfig& config;
  Bus& bus;
  Health& health;
  int uav = 0;  ///< 1..N in a module that serves one UAV, else 0
  std::shared_ptr<MapHearer>
      map_hearer;  ///< one a process: whoever needs the map hears it through this; null in a
                   ///< module that declares `static constexpr bool kHearsMap = false`
  std::shared_ptr<const sim::World> world = nullptr;  ///< if whoever started this process holds it: WorldOf()
};

/// A module: `kName`, `kSummary`, `kHearsMap`, `kPerUav`, a constructor (const ModuleContext&) that
/// subscribes, and Tick().
class Module {
 public:
  virtual ~Module() = default;
  /// Does what is due at `step`. No threads, no globals, no clock.
  virtual void Tick(const Step& step) = 0;
};

}  // namespace citrine

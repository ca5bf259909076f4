#pragma once

#include <memory>

#include "modules/runtime/module.h"
#include "sim/world/world.h"

namespace citrine {

/// The world of a module's mission: what its process holds already, else read from `mission.world`.
/// @throws sim::WorldError
inline std::shared_ptr<const sim::World> WorldOf(const ModuleContext& context) {
  return context.world ? context.world
                       : std::make_shared<const sim::World>(sim::LoadWorld(context.config.mission.world));
}

}  // namespace citrine

#pragma once

#include "modules/runtime/module_kind.h"

namespace citrine {

/// The whole `main` of a module: options, mission, bus, loop, signals.
/// @return exit code: 0 the mission ended, 1 wrong use, 2 the mission or the bus cannot be used, 4 the module
/// failed
int RunModule(const ModuleKind& kind, int argc, char** argv);

template <class M>
int RunModule(int argc, char** argv) {
  return RunModule(KindOf<M>(), argc, argv);
}

}  // namespace citrine

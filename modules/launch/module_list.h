#pragma once

#include <vector>

#include "modules/runtime/module_kind.h"

namespace citrine {

/// THE LIST of the modules that fly a mission. In one process they tick in this order.
std::vector<ModuleKind> ModuleList();

}  // namespace citrine

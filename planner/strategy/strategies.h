#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/config/mission_config.h"
#include "planner/strategy/strategy.h"

namespace citrine::planner {

/// The list of strategies: one row each, in strategies.cpp.
std::vector<std::string> StrategyNames();

/// @throws ConfigError for a name that is not in the list
std::unique_ptr<Strategy> MakeStrategy(const PlannerSection& config);

}  // namespace citrine::planner

#pragma once

#include <string>

#include "planner/strategy/decision.h"

namespace citrine {

/// A decision as a table for the terminal: the situation, the candidates with the highest scores, the one
/// that was chosen, and by what it is ahead of the next.
/// @param rows candidates listed at most, besides the chosen one
std::string DecisionText(const planner::Decision& decision, int rows);

}  // namespace citrine

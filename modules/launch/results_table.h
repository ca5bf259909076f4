#pragma once

#include <string>

#include "logs/metrics.h"

namespace citrine {

/// What a mission came to, in a few lines for the terminal.
std::string ResultsTable(const logs::Metrics& metrics, const std::string& out);

}  // namespace citrine

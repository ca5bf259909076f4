#pragma once

#include <string>

#include "logs/report_page.h"

namespace citrine::logs {

/// The true surface seen from within d*, over mission time; empty without the truth.
std::string CoveragePlot(const ReportPage& page);

/// Over mission time: goals that each UAV has chosen, and imbalance corrections of the fleet.
std::string DecisionPlots(const ReportPage& page);

}  // namespace citrine::logs

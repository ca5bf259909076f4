#pragma once

#include <string>

#include "logs/report_page.h"

namespace citrine::logs {

/// The result in one sentence, in a box.
std::string VerdictLine(const ReportPage& page);

/// This run above the paper's rows of the same world; without them for a world that the paper does not have.
std::string PaperTable(const ReportPage& page);

/// The remaining numbers in groups: reconstruction, flight, decisions, system.
std::string NumberTables(const ReportPage& page);

}  // namespace citrine::logs

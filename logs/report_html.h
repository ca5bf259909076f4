#pragma once

#include <string>

#include "logs/report_page.h"

namespace citrine::logs {

/// report.html: one file that opens without a network. Verdict, numbers beside the paper's table II, the
/// picture from above, curves over time, workload, bus and computing times, the configuration and the command
/// that flies it again.
std::string ReportHtml(const ReportPage& page);

}  // namespace citrine::logs

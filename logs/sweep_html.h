#pragma once

#include <string>

#include "logs/sweep_plots.h"
#include "logs/sweep_results.h"

namespace citrine::logs {

/// Tables, figures and the command on one page that needs no network.
std::string SweepHtml(const SweepResults& results, const std::vector<NamedFigure>& figures);

}  // namespace citrine::logs

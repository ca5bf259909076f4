#pragma once

#include <optional>
#include <string>
#include <vector>

#include "logs/svg_parts.h"

namespace citrine::logs {

/// One row of a figure of intervals.
struct IntervalRow {
  std::string name;
  std::vector<double> values;       ///< one a run
  double mean = 0, half_width = 0;  ///< of the confidence interval; NaN where there is none
  int colour = 0;
};

/// Runs as faint dots, their mean as a dot with its interval, a row each over a common axis from zero.
/// @param mark a level with a name, such as what the paper reports
/// @param most [same unit] where the axis ends at the latest, such as 100 %
SvgFigure IntervalFigure(const std::string& title, const std::string& x_label,
                         const std::vector<IntervalRow>& rows,
                         const std::optional<std::pair<std::string, double>>& mark, double most);

}  // namespace citrine::logs

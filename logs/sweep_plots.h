#pragma once

#include <string>
#include <vector>

#include "logs/svg_parts.h"
#include "logs/sweep_results.h"

namespace citrine::logs {

/// A figure and the name of its file, without the extension.
struct NamedFigure {
  std::string name;
  SvgFigure figure;
};

/// For each world: what the plan wants over time, as the mean over seeds; every column over x, if the
/// variants have one; otherwise every column by variant, with 95 % confidence intervals and the paper's
/// value.
std::vector<NamedFigure> SweepFigures(const SweepResults& results);

/// The mean of several series at `count` instants from zero to the latest end. A series that has ended keeps
/// its last value; one that has not begun counts as 0. Empty of nothing.
Series MeanOverTime(const std::vector<const Series*>& series, int count);

}  // namespace citrine::logs

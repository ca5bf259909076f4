#pragma once

#include <string>

#include "logs/sweep_results.h"
#include "logs/text_table.h"

namespace citrine::logs {

/// A world's variants, a row each: how many missions were completed, and mean and standard deviation over
/// seeds of every column; below them the paper's rows for it, if any.
TextTable MeansTable(const SweepResults& results, const SweepWorld& world);

/// Every other variant less the baseline, seed by seed: mean and 95 % confidence interval; a star where the
/// difference is significant (paired t test, 5 %). Without rows if there is but one variant.
TextTable DifferencesTable(const SweepResults& results, const SweepWorld& world);

/// A line a run, with everything of metrics.json that is one number.
std::string RunsCsv(const SweepResults& results);

/// A line for each world, variant and column: the numbers of both tables.
std::string SummaryCsv(const SweepResults& results);

/// All tables, with what a reader should know of them.
std::string SweepMarkdown(const SweepResults& results);
std::string SweepLatex(const SweepResults& results);

}  // namespace citrine::logs

#pragma once

#include <string>
#include <vector>

#include "logs/sweep_results.h"
#include "modules/launch/sweep/sweep_jobs.h"

namespace citrine {

/// Digest of this program: what tells runs of one build from those of another.
std::string ProgramDigest();

enum class JobState {
  kOpen,           ///< not flown, not to the end, or with another configuration
  kFinished,       ///< by this build
  kOfAnotherBuild  ///< finished, but what another build does may differ
};
JobState StateOf(const SweepJob& job, const std::string& program_digest);

/// Notes in the job's folder what it is and which build flies it; an earlier result is no longer valid.
void Begin(const SweepJob& job, const std::string& program_digest);

/// Metrics of a finished job, whichever build flew it; nothing if it is open.
std::optional<logs::Metrics> MetricsOf(const SweepJob& job);

/// What is finished of a sweep.
logs::SweepResults ReadResults(const Sweep& sweep);

/// Writes tables.md, tables.tex, runs.csv, summary.csv, report.html and figures/*.svg into the sweep's
/// folder.
/// @throws std::runtime_error if that fails
void WriteTables(const Sweep& sweep, const logs::SweepResults& results);

}  // namespace citrine

#pragma once

#include <string>
#include <vector>

#include "core/config/sweep_plan.h"
#include "modules/launch/sweep/sweep_options.h"

namespace citrine {

/// One mission of a sweep.
struct SweepJob {
  std::string world, variant;
  int seed = 0;
  std::string folder;   ///< of its results: relative to the project if they are in it
  std::string command;  ///< `run` with all that decides what is flown, but not where to; from the project's
                        ///< folder
};

/// A sweep as it is to be flown.
struct Sweep {
  SweepPlan plan;                     ///< with what the options change
  std::string folder;                 ///< of all results, absolute
  std::string command;                ///< that makes it
  std::vector<SweepJob> jobs;         ///< by seed, then world and variant: pairs are complete early
  std::vector<std::string> left_out;  ///< a sentence for each world that is not there
};

/// Finds and reads a sweep file, and checks the configuration of each of its missions.
/// @throws ConfigError
Sweep PlanSweep(const SweepOptions& options);

/// A line of shell, to be run in the project's folder, that flies a job with `program` and leaves its results
/// in the job's folder, what it says in run.log there. What is large and can be flown again is taken away,
/// unless the plan keeps it.
std::string ShellLine(const SweepJob& job, const std::string& program, bool keep_logs);

/// A text as one word of a shell.
std::string ShellWord(const std::string& text);

}  // namespace citrine

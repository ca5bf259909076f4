#pragma once

#include <functional>
#include <string>
#include <vector>

#include "modules/launch/sweep/sweep_jobs.h"

namespace citrine {

/// A job that has ended.
struct EndedJob {
  std::size_t index = 0;  ///< in the list of jobs
  int exit_code = 0;
  double start_s = 0, wall_s = 0;  ///< on the host's clock
};

/// GNU Parallel's job log, in the folder of ParallelOptions.
inline constexpr const char* kJobLog = "joblog.tsv";

struct ParallelOptions {
  std::string folder;   ///< for the job list and what GNU Parallel says
  std::string program;  ///< that flies
  int jobs = 0;         ///< at once on a host; 0: one a processor
  std::string hosts;    ///< of SSH, separated by commas; empty: this machine
  bool keep_logs = false;
};

/// Runs jobs through GNU Parallel. On other hosts the project lies in a folder of the same path, and results
/// come back by rsync. An interrupt lets those under way end, a second one does not.
/// @param on_end called in the order in which they end
/// @return whether all jobs have been run
/// @throws ConfigError if GNU Parallel is not installed, or cannot do it
bool RunInParallel(const std::vector<SweepJob>& jobs, const ParallelOptions& options,
                   const std::function<void(const EndedJob&)>& on_end);

/// Lines of GNU Parallel's job log, which begins with a line of names; one that is cut short is left for
/// later.
std::vector<EndedJob> ReadJobLog(const std::string& text);

}  // namespace citrine

#pragma once

#include <string>

#include "modules/launch/replay_options.h"
#include "modules/launch/run_options.h"
#include "modules/launch/sweep/sweep_options.h"

namespace citrine {

/// How a command ends (design, section 4).
enum ExitCode : int {
  kCompleted = 0,
  kWrongUse = 1,
  kSetUpProblem = 2,
  kNotCompleted = 3,  ///< or with a collision
  kModuleDied = 4,
  kInterrupted = 130,
};

// One function a command, in a file of its own. @return the exit code. @throws whatever makes it a set-up
// problem

int RunMission(const RunOptions& options);
int Doctor();
int ShowKeys();
int ShowWorld(const std::string& file);
/// @param to "mcap"  @param out file to write; empty: beside the log
int ExportLog(const std::string& log, const std::string& to, const std::string& out);
int ReplayLog(const ReplayOptions& options);
int Report(const std::string& folder_or_log);
int RunSweep(const SweepOptions& options);
int CompareResults(const std::string& a, const std::string& b);

}  // namespace citrine

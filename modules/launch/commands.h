#pragma once

#include <optional>
#include <string>

#include "modules/launch/explain_options.h"
#include "modules/launch/message_source.h"
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

/// How one comes by a display, for messages to the user.
inline constexpr const char* kDisplay = "ssh -X, or xvfb-run -a ./citrine run MISSION --view";

struct EchoOptions {
  SourceOptions source;
  std::string channel;  ///< a channel, or a regular expression that matches the whole of several
  int count = 0;        ///< messages after which it ends; 0: all
  bool json = false;    ///< one line of JSON a message
};

struct SpyOptions {
  SourceOptions source;
  std::string screenshot;         ///< a PNG of the screen, after which it ends; empty: none
  double screenshot_after_s = 5;  ///< of the wall
};

/// What `log cut` keeps.
struct CutOptions {
  std::string log, to;                 ///< a log or a result folder; the log to write
  std::optional<double> from_s, to_s;  ///< mission time, both included
  std::string channels;                ///< regular expression that matches the whole of a channel; empty: all
};

/// Recorded clouds, and what to make of them.
struct FuseOptions {
  std::string scans, poses, out;
  double voxel_m = 0.25;
  double truncation_m = 0;  ///< 0: two voxels
  double range_max_m = 30;
};

// One function a command, in a file of its own. @return the exit code. @throws whatever makes it a set-up
// problem

int RunMission(const RunOptions& options);
int Doctor();
int ShowKeys();
int ShowWorld(const std::string& file);
/// @param to "mcap"  @param out file to write; empty: beside the log
int ExportLog(const std::string& folder_or_log, const std::string& to, const std::string& out);
int ExplainDecision(const ExplainOptions& options);
int ReplayLog(const ReplayOptions& options);
int Report(const std::string& folder_or_log);
int RunSweep(const SweepOptions& options);
int Fuse(const FuseOptions& options);
int CompareResults(const std::string& a, const std::string& b);
/// @param seconds to listen before it prints once; 0: redrawn until Ctrl-C on a terminal
int Top(const SourceOptions& source, double seconds);
int EchoChannel(const EchoOptions& options);
/// Becomes lcm-spy; comes back by an exception alone.
int Spy(const SpyOptions& options);
int LogInfo(const std::string& folder_or_log);
int LogCheck(const std::string& folder_or_log);
int LogCut(const CutOptions& options);

}  // namespace citrine

#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/config/sweep_plan.h"
#include "logs/flight_measures.h"
#include "logs/metrics.h"
#include "logs/statistics.h"

namespace citrine::logs {

/// One finished mission of a sweep.
struct SweepRun {
  std::string world, variant;  ///< names of the plan
  int seed = 0;
  Metrics metrics;
  std::map<std::string, Series> over_time;  ///< of the plan's `over_time`, by column of progress.csv
};

/// What a sweep has come to so far.
struct SweepResults {
  SweepPlan plan;
  std::vector<SweepRun> runs;      ///< in order of world, variant and seed
  std::string command;             ///< that makes it
  std::vector<std::string> notes;  ///< one sentence each: what a reader of the numbers should know
};

/// Runs of one world with one variant.
std::vector<const SweepRun*> RunsOf(const SweepResults& results, const std::string& world,
                                    const std::string& variant);

/// The values of a key of metrics.json; runs that have none are left out.
std::vector<double> ValuesOf(const std::vector<const SweepRun*>& runs, const std::string& key);

/// How much larger a key's value is in `b` than in `a`, over the seeds that both have flown.
PairedDifference PairBySeed(const std::vector<const SweepRun*>& a, const std::vector<const SweepRun*>& b,
                            const std::string& key);

/// The plan's columns, or those of the paper.
std::vector<std::string> ColumnsOf(const SweepPlan& plan);

}  // namespace citrine::logs

#pragma once

#include <map>
#include <string>
#include <vector>

#include "logs/metrics.h"

namespace citrine::logs {

/// A finished mission on one side of a comparison.
struct ComparedRun {
  std::string cell;                           ///< world and variant of a sweep; empty: a run by itself
  Metrics metrics;                            ///< whose seed makes the pairs
  std::map<std::string, std::string> config;  ///< value by key, as it was flown
};

/// What differs between two runs, or two sets of runs of the same cells and seeds: keys of the configuration;
/// then cell by cell every number of metrics.json that differs, with mean and standard deviation on each side
/// and the paired difference b - a, its 95 % confidence interval and p. What has no partner is named.
std::string Compare(const std::vector<ComparedRun>& a, const std::vector<ComparedRun>& b);

}  // namespace citrine::logs

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "logs/metrics.h"

namespace citrine::logs {

/// How a key of metrics.json is written in a table's head.
struct MetricLabel {
  std::string name;  ///< such as "Makespan"; the key itself where it has no other
  std::string unit;  ///< "" of a count
  int decimals = 2;
};
MetricLabel LabelOf(const std::string& key);
/// "Makespan (m)"
std::string HeadOf(const std::string& key);

/// Value of a key of metrics.json that holds one number (yes and no: 1 and 0); nothing where it is null.
std::optional<double> MetricNumber(const Metrics& metrics, const std::string& key);

/// Keys that hold one number, in the file's order.
std::vector<std::string> NumberKeys();

/// What a sweep's tables show if it does not say: the paper's columns, and what of the goal was reached.
std::vector<std::string> PaperColumns();

}  // namespace citrine::logs

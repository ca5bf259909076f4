#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace citrine {

/// What a module measures of itself; said in MODULE_HEALTH, the only message that carries wall time, and
/// gathered by the report. Never read by a decision.
class Health {
 public:
  /// One sample of a named quantity, such as "replan_ms" or "views"; the report prints its percentiles.
  void Sample(const std::string& name, double value) { samples_[name].push_back(static_cast<float>(value)); }
  /// The newest error, in one line.
  void Error(const std::string& what) { last_error_ = what; }

  /// Samples since the last call, by name.
  std::map<std::string, std::vector<float>> TakeSamples() { return std::exchange(samples_, {}); }
  const std::string& last_error() const { return last_error_; }

 private:
  std::map<std::string, std::vector<float>> samples_;
  std::string last_error_;
};

}  // namespace citrine

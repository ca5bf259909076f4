#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "modules/launch/sweep/sweep_jobs.h"

namespace citrine {

/// How far a sweep is. Missions of one world and variant are taken to last alike.
class SweepProgress {
 public:
  /// @param slots missions flown at once
  SweepProgress(const std::vector<SweepJob>& jobs, int slots);

  void Ended(std::size_t job, double wall_s);
  std::size_t ended() const { return ended_; }

  /// [s] of the wall until all have ended: what is open, each at the mean of its world and variant, else of
  /// its world, else of all, over the slots; nothing before the first has ended.
  std::optional<double> TimeLeft_s() const;

 private:
  struct Sum {
    double wall_s = 0;
    int count = 0;
  };
  double Expected_s(const SweepJob& job) const;

  std::vector<SweepJob> open_;
  std::vector<bool> done_;
  int slots_;
  std::size_t ended_ = 0;
  std::map<std::string, Sum> by_cell_, by_world_;
  Sum all_;
};

}  // namespace citrine

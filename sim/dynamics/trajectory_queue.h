#pragma once

#include <deque>

#include "core/trajectory/trajectory.h"

namespace citrine::sim {

/// What one UAV follows: a trajectory takes effect at its start time, and the older one is flown until then.
class TrajectoryQueue {
 public:
  explicit TrajectoryQueue(Trajectory first) : current_(std::move(first)) {}

  /// A newer trajectory supersedes those that would begin with it or after it.
  void Add(Trajectory trajectory);

  /// What is asked at `now`; calls go forward in time.
  TrajectoryPoint At(Utime now);

  /// What will be asked at a later time, as far as is known.
  TrajectoryPoint Foresee(Utime later) const;

 private:
  Trajectory current_;
  std::deque<Trajectory> later_;  ///< by start
};

}  // namespace citrine::sim

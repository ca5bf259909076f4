#include "sim/dynamics/trajectory_queue.h"

#include <algorithm>
#include <utility>

namespace citrine::sim {

void TrajectoryQueue::Add(Trajectory trajectory) {
  while (!later_.empty() && later_.back().start >= trajectory.start) later_.pop_back();
  later_.push_back(std::move(trajectory));
}

TrajectoryPoint TrajectoryQueue::At(Utime now) {
  while (!later_.empty() && later_.front().start <= now) {
    current_ = std::move(later_.front());
    later_.pop_front();
  }
  return current_.At(now);
}

TrajectoryPoint TrajectoryQueue::Foresee(Utime later) const {
  const auto begun = std::find_if(later_.rbegin(), later_.rend(), [later](const Trajectory& trajectory) {
    return trajectory.start <= later;
  });
  return (begun == later_.rend() ? current_ : *begun).At(later);
}

}  // namespace citrine::sim

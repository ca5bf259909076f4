#include "modules/launch/sweep/sweep_progress.h"

#include <algorithm>

namespace citrine {

SweepProgress::SweepProgress(const std::vector<SweepJob>& jobs, int slots)
    : open_(jobs), done_(jobs.size(), false), slots_(std::max(slots, 1)) {}

void SweepProgress::Ended(std::size_t job, double wall_s) {
  done_[job] = true;
  ++ended_;
  const SweepJob& ended = open_[job];
  for (Sum* sum : {&by_cell_[ended.world + "/" + ended.variant], &by_world_[ended.world], &all_}) {
    sum->wall_s += wall_s;
    ++sum->count;
  }
}

double SweepProgress::Expected_s(const SweepJob& job) const {
  Sum sum = all_;
  if (const auto world = by_world_.find(job.world); world != by_world_.end()) sum = world->second;
  if (const auto cell = by_cell_.find(job.world + "/" + job.variant); cell != by_cell_.end())
    sum = cell->second;
  return sum.wall_s / sum.count;
}

std::optional<double> SweepProgress::TimeLeft_s() const {
  if (ended_ == 0) return std::nullopt;
  double work_s = 0, longest_s = 0;
  for (std::size_t i = 0; i < open_.size(); ++i) {
    if (done_[i]) continue;
    work_s += Expected_s(open_[i]);
    longest_s = std::max(longest_s, Expected_s(open_[i]));
  }
  return std::max(work_s / slots_, longest_s);
}

}  // namespace citrine

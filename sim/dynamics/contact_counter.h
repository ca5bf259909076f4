#pragma once

#include <map>
#include <utility>
#include <vector>

#include "core/time.h"

namespace citrine::sim {

/// Counts collisions: the onset of a contact between a UAV and a partner, and a new one only after they were
/// apart for kApart_s. Partner 0 is the world, else another UAV's id; between two UAVs it counts for both.
class ContactCounter {
 public:
  static constexpr double kApart_s = 0.5;

  explicit ContactCounter(int uavs) : counts_(static_cast<std::size_t>(uavs) + 1, 0) {}

  /// `uav` (1..N) and `partner` touch at `now`; said in every step of a contact.
  void Touch(int uav, int partner, Utime now);

  int count(int uav) const { return counts_[static_cast<std::size_t>(uav)]; }

 private:
  std::map<std::pair<int, int>, Utime> last_touch_;  ///< smaller id first
  std::vector<int> counts_;
};

}  // namespace citrine::sim

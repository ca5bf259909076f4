#include "sim/dynamics/contact_counter.h"

#include <algorithm>

namespace citrine::sim {

void ContactCounter::Touch(int uav, int partner, Utime now) {
  const auto [last, first_time] = last_touch_.try_emplace(std::minmax({uav, partner}), now);
  if (first_time || now - last->second > FromSeconds(kApart_s)) {
    ++counts_[static_cast<std::size_t>(uav)];
    if (partner > 0) ++counts_[static_cast<std::size_t>(partner)];
  }
  last->second = now;
}

}  // namespace citrine::sim

#pragma once

#include <ctime>

namespace citrine {

/// Computing time of this thread, for Health alone: what else the host does meanwhile does not count.
class CpuStopwatch {
 public:
  double ms() const { return Now() - start_; }

 private:
  static double Now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  }
  double start_ = Now();
};

}  // namespace citrine

#pragma once

#include <ctime>

namespace citrine {

/// Computing time, for Health alone: what else the host does meanwhile does not count.
class CpuStopwatch {
 public:
  /// That of this thread, or of all threads of the process, for work that is shared among them.
  enum class Of { kThread, kProcess };
  explicit CpuStopwatch(Of of = Of::kThread)
      : clock_(of == Of::kThread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID) {}
  double ms() const { return Now() - start_; }

 private:
  double Now() const {
    timespec time{};
    clock_gettime(clock_, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  }
  clockid_t clock_;
  double start_ = Now();
};

}  // namespace citrine

#pragma once

#include <sched.h>
#include <time.h>

#include <algorithm>
#include <vector>

namespace citrine::bench {

/// Keeps this process on the core that it is on: then nothing is shared among threads, and one thread's work
/// is what is measured. To be called before any.
inline void StayOnOneCore() {
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(sched_getcpu(), &one);
  sched_setaffinity(0, sizeof one, &one);
}

/// [ms] of this process's time on processors, so that what else runs on the machine counts little.
inline double CpuMs() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

template <class Work>
double TimeMs(Work&& work) {
  const double start = CpuMs();
  work();
  return CpuMs() - start;
}

/// Of samples that came one by one.
struct Samples {
  std::vector<double> values;
  void Add(double value) { values.push_back(value); }
  double sum() const {
    double total = 0;
    for (const double value : values) total += value;
    return total;
  }
  double mean() const { return sum() / static_cast<double>(std::max<std::size_t>(values.size(), 1)); }
  double median() const {
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    return sorted.empty() ? 0 : sorted[sorted.size() / 2];
  }
};

}  // namespace citrine::bench

#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace citrine {

/// Calls run(part) once for each part from 0 on, on this thread and on those of a pool as far as they are
/// idle; on this one alone while another thread has the pool. What each part does must not depend on the
/// others. Throws what a part has thrown, the lowest one's, once all are over.
void RunParts(int parts, const std::function<void(int part)>& run);

/// Calls work(begin, end) on `parts` equal parts of [0, count), as above. The result does not depend on the
/// number of threads; nor on that of parts, if what is done for one element does not depend on the others.
template <class Work>
void ParallelFor(int count, int parts, Work&& work) {
  parts = std::clamp(parts, 1, std::max(count, 1));
  const auto begin = [&](int part) { return static_cast<int>(static_cast<long long>(count) * part / parts); };
  if (parts == 1)
    work(0, count);
  else
    RunParts(parts, [&](int part) { work(begin(part), begin(part + 1)); });
}

/// Calls work(i) for every i of [0, count), likewise.
template <class Work>
void ParallelForEach(std::size_t count, int parts, Work&& work) {
  ParallelFor(static_cast<int>(count), parts, [&](int begin, int end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) work(i);
  });
}

}  // namespace citrine

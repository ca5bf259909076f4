#pragma once

#include <algorithm>
#include <thread>
#include <vector>

namespace citrine {

/// Calls work(begin, end) on `parts` equal parts of [0, count), each on a thread of its own. What each part
/// does must not depend on the others; then the result does not depend on the number of parts.
template <class Work>
void ParallelFor(int count, int parts, Work&& work) {
  parts = std::clamp(parts, 1, std::max(count, 1));
  const auto begin = [&](int part) { return static_cast<int>(static_cast<long long>(count) * part / parts); };
  std::vector<std::thread> threads;
  for (int part = 1; part < parts; ++part)
    threads.emplace_back([&, part] { work(begin(part), begin(part + 1)); });
  work(begin(0), begin(1));
  for (std::thread& thread : threads) thread.join();
}

}  // namespace citrine

#include "core/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

namespace citrine {
namespace {

TEST(ParallelFor, WorksOnEveryElementOnceInPartsThatOnlyTheirNumberDecides) {
  for (const int count : {0, 1, 7, 1000})
    for (const int parts : {-1, 1, 2, 8, 2000}) {
      std::vector<int> times(static_cast<std::size_t>(count));
      std::atomic<int> calls = 0;
      ParallelFor(count, parts, [&](int begin, int end) {
        ++calls;
        for (int i = begin; i < end; ++i) ++times[static_cast<std::size_t>(i)];
      });
      EXPECT_EQ(times, std::vector<int>(times.size(), 1));
      EXPECT_EQ(calls, std::clamp(parts, 1, std::max(count, 1)));
    }
}

TEST(ParallelFor, MayBeCalledFromWithinItselfAndFromSeveralThreadsAtOnce) {
  std::atomic<int> sum = 0;
  const auto add = [&] {
    for (int round = 0; round < 200; ++round)
      ParallelFor(16, 4, [&](int begin, int end) {
        ParallelFor(end - begin, 2, [&](int first, int last) { sum += last - first; });
      });
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < 3; ++i) threads.emplace_back(add);
  add();
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(sum, 4 * 200 * 16);
}

TEST(ParallelFor, ThrowsWhatTheLowestPartThrewOnceAllAreOver) {
  std::atomic<int> over = 0;
  const auto work = [&](int begin, int) {
    ++over;
    if (begin >= 3) throw std::runtime_error(std::to_string(begin));
  };
  try {
    ParallelFor(8, 8, work);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "3");
  }
  EXPECT_EQ(over, 8);
}

}  // namespace
}  // namespace citrine

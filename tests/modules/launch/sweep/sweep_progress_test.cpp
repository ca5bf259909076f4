#include "modules/launch/sweep/sweep_progress.h"

#include <gtest/gtest.h>

namespace citrine {
namespace {

std::vector<SweepJob> Jobs() {
  std::vector<SweepJob> jobs;
  for (int seed = 1; seed <= 2; ++seed)
    for (const char* world : {"house", "yard"})
      for (const char* variant : {"a", "b"}) jobs.push_back({world, variant, seed, "", ""});
  return jobs;  // house a, house b, yard a, yard b, and again
}

TEST(SweepProgress, KnowsNothingBeforeTheFirstHasEnded) {
  EXPECT_FALSE(SweepProgress(Jobs(), 2).TimeLeft_s().has_value());
}

TEST(SweepProgress, TakesWhatIsOpenToLastAsLongAsItsKind) {
  SweepProgress progress(Jobs(), 1);
  progress.Ended(0, 60);
  EXPECT_EQ(*progress.TimeLeft_s(), 7 * 60);  // of all, for want of better
  progress.Ended(1, 100);
  progress.Ended(2, 10);
  // Once each: house a 60, house b 100, yard a 10; yard b twice as the yard's: 10.
  EXPECT_EQ(*progress.TimeLeft_s(), 60 + 100 + 10 + 2 * 10);
  EXPECT_EQ(progress.ended(), 3u);
}

TEST(SweepProgress, EndsNoEarlierThanItsLongestMission) {
  SweepProgress progress(Jobs(), 8);
  progress.Ended(0, 60);  // seven more in eight slots
  EXPECT_EQ(*progress.TimeLeft_s(), 60);
  for (std::size_t i = 1; i < 8; ++i) progress.Ended(i, 1);
  EXPECT_EQ(*progress.TimeLeft_s(), 0);
}

}  // namespace
}  // namespace citrine

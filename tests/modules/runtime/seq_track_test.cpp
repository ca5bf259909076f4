#include "modules/runtime/seq_track.h"

#include <gtest/gtest.h>

namespace citrine {
namespace {

TEST(SeqTrack, CountsWhatIsMissingBetweenTwoMessages) {
  SeqTrack track;
  EXPECT_EQ(track.Advance(0, 5).lost, 0) << "a late joiner misses nothing";
  EXPECT_EQ(track.Advance(1, 6).lost, 0);
  EXPECT_EQ(track.Advance(2, 9).lost, 2);
}

TEST(SeqTrack, KnowsARepetition) {
  SeqTrack track;
  EXPECT_TRUE(track.Advance(0, 5).is_new);
  EXPECT_FALSE(track.Advance(0, 5).is_new);
  EXPECT_FALSE(track.Advance(0, 4).is_new);
}

TEST(SeqTrack, FollowsASenderThatBeganAnew) {
  SeqTrack track;
  track.Advance(100, 50);
  const auto arrival = track.Advance(120, 1);
  EXPECT_TRUE(arrival.is_new);
  EXPECT_EQ(arrival.lost, 0);
  EXPECT_EQ(track.Advance(140, 3).lost, 1);
}

}  // namespace
}  // namespace citrine

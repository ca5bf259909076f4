#include "modules/replay/comparison.h"

#include <gtest/gtest.h>

#include "tests/modules/replay/recorded_words.h"

namespace citrine {
namespace {

using test::RecordedPath;
using test::RecordedState;
using test::RecordedTrajectory;

TEST(Comparison, FindsNothingBetweenARecordingAndItself) {
  const std::vector<LogEvent> events{RecordedState(0, 1, 1.5), RecordedState(20'000, 2, 1.6)};
  const Comparison comparison = Compare(events, events, kIdentical);
  EXPECT_EQ(comparison.recorded, 2);
  EXPECT_EQ(comparison.different, 0);
  EXPECT_FALSE(comparison.first);
}

TEST(Comparison, NamesChannelTimeAndFieldOfTheFirstDifference) {
  const std::vector<LogEvent> recorded{RecordedState(0, 1, 1.5), RecordedState(12'400'000, 2, 4.35),
                                       RecordedState(12'420'000, 3, 4.4)};
  const std::vector<LogEvent> said{RecordedState(0, 1, 1.5), RecordedState(12'400'000, 2, 4.1),
                                   RecordedState(12'420'000, 3, 4.2)};
  const Comparison comparison = Compare(recorded, said, kIdentical);
  EXPECT_EQ(comparison.different, 2);
  ASSERT_TRUE(comparison.first);
  EXPECT_EQ(comparison.first->Text(), "UAV1_STATE at t = 12.40 s, message 2: p_WB[0] is 4.1, recorded 4.35");
}

TEST(Comparison, SeesTheLastBitOfANumberWhereAllIsToBeIdenticalButNotOnAnotherProcessor) {
  const std::vector<LogEvent> recorded{RecordedState(0, 1, 1.0)};
  const std::vector<LogEvent> said{RecordedState(0, 1, std::nextafter(1.0, 2.0))};
  EXPECT_EQ(Compare(recorded, said, kIdentical).different, 1);
  EXPECT_EQ(Compare(recorded, said, kOtherProcessor).different, 0);
  EXPECT_EQ(Compare(recorded, {RecordedState(0, 1, 1.00001)}, kOtherProcessor).different, 1);
}

TEST(Comparison, CountsWhatWasNotSaidAndWhatWasNotRecorded) {
  const std::vector<LogEvent> recorded{RecordedState(0, 1, 1), RecordedState(20'000, 2, 1)};
  const std::vector<LogEvent> said{RecordedState(20'000, 2, 1), RecordedState(40'000, 3, 1)};
  const Comparison comparison = Compare(recorded, said, kIdentical);
  EXPECT_EQ(comparison.different, 2);
  ASSERT_TRUE(comparison.first);
  EXPECT_EQ(comparison.first->Text(),
            "UAV1_STATE at t = 0.00 s, message 1: nothing was said, recorded a message");
}

TEST(Comparison, TellsADecisionFromAMeasurement) {
  const auto first_is_decision = [](const LogEvent& recorded, const LogEvent& said) {
    return Compare({recorded}, {said}, kOtherProcessor).first_is_decision;
  };
  EXPECT_TRUE(first_is_decision(RecordedPath(0, 1, 2), RecordedPath(0, 1, 3)));
  EXPECT_FALSE(first_is_decision(RecordedState(0, 1, 2), RecordedState(0, 1, 3)));
}

TEST(Comparison, SaysWhichArrayIsOfAnotherLength) {
  citrine_lcm::path_t none{};
  none.path_id = 7;
  const LogEvent stop = test::Recorded(channels::kPath.Of(1), 0, 1, none);
  const Comparison comparison = Compare({RecordedPath(0, 1, 2)}, {stop}, kIdentical);
  ASSERT_TRUE(comparison.first);
  EXPECT_EQ(comparison.first->field, "num_waypoints");
}

TEST(PacedComparison, TakesWhatIsSaidAStepLaterUnderAnotherCountForTheSame) {
  const std::vector<LogEvent> recorded{RecordedPath(1'000'000, 4, 2)};
  EXPECT_EQ(Compare(recorded, {RecordedPath(1'020'000, 5, 2.1)}, kPaced).different, 0);
  EXPECT_EQ(Compare(recorded, {RecordedPath(1'020'000, 5, 2.6)}, kPaced).different, 1) << "0.6 m off";
  EXPECT_EQ(Compare(recorded, {RecordedPath(1'600'000, 5, 2)}, kPaced).different, 1) << "0.6 s late";
}

TEST(PacedComparison, ComparesTrajectoriesByWhereTheyLead) {
  const std::vector<LogEvent> recorded{RecordedTrajectory(1'000'000, 1, 1'100'000)};
  EXPECT_EQ(Compare(recorded, {RecordedTrajectory(1'020'000, 1, 1'120'000)}, kPaced).different, 0)
      << "the same line, planned a step later";
  citrine_lcm::trajectory_t still{};
  still.trajectory_id = 1;
  still.start_utime = 1'100'000;
  still.num_segments = 1;
  still.num_coefficients = 6;
  still.duration_s = {1};
  still.x_W = still.y_W = still.z_W = still.yaw_rad = std::vector<double>(6, 0);
  const Comparison comparison =
      Compare(recorded, {test::Recorded(channels::kTrajectory.Of(1), 1'000'000, 1, still)}, kPaced);
  ASSERT_TRUE(comparison.first);
  EXPECT_EQ(comparison.first->field, "p_W(1.00 s)[0]");
}

}  // namespace
}  // namespace citrine

#include "logs/percentile.h"

#include <gtest/gtest.h>

namespace citrine::logs {
namespace {

TEST(Percentile, IsLinearBetweenRanks) {
  const std::vector<float> samples = {40, 10, 30, 20};
  EXPECT_DOUBLE_EQ(*Percentile(samples, 0), 10);
  EXPECT_DOUBLE_EQ(*Percentile(samples, 50), 25);
  EXPECT_DOUBLE_EQ(*Percentile(samples, 90), 37);
  EXPECT_DOUBLE_EQ(*Percentile(samples, 100), 40);
}

TEST(Percentile, OfOneSampleIsThatSampleAndOfNoneIsNothing) {
  EXPECT_DOUBLE_EQ(*Percentile({3}, 95), 3);
  EXPECT_FALSE(Percentile({}, 95).has_value());
}

}  // namespace
}  // namespace citrine::logs

#include "modules/runtime/token_bucket.h"

#include <gtest/gtest.h>

namespace citrine {
namespace {

TEST(TokenBucket, PassesTheRateOverTimeAndTheBurstAtOnce) {
  TokenBucket bucket(1000, 500);
  EXPECT_TRUE(bucket.Take(500));
  EXPECT_FALSE(bucket.Take(1));
  bucket.Refill(FromSeconds(0.25));
  EXPECT_TRUE(bucket.Take(250));
  EXPECT_FALSE(bucket.Take(1));
  bucket.Refill(FromSeconds(100));
  EXPECT_TRUE(bucket.Take(500));
  EXPECT_FALSE(bucket.Take(1)) << "no more than a burst is saved up";
}

TEST(TokenBucket, PassesAMessageLargerThanTheBurstAndMakesTheNextWait) {
  TokenBucket bucket(1000, 500);
  EXPECT_TRUE(bucket.Take(900));
  bucket.Refill(FromSeconds(0.4));
  EXPECT_FALSE(bucket.Take(1));
  bucket.Refill(FromSeconds(0.5));
  EXPECT_TRUE(bucket.Take(1));
}

}  // namespace
}  // namespace citrine

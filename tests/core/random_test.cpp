#include "core/random.h"

#include <vector>

#include <gtest/gtest.h>

namespace citrine {
namespace {

TEST(Random, AdvancesAsFarAsTakingNumbersDoes) {
  for (const std::uint64_t n : {0, 1, 2, 3, 17, 64, 1000, 11521}) {
    Random taken(5, 9), advanced(5, 9);
    for (std::uint64_t i = 0; i < n; ++i) taken.Next();
    advanced.Advance(n);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(advanced.Next(), taken.Next()) << "after " << n;
  }
}

TEST(Random, TakesAsManyNumbersForANormalOneAsItSays) {
  Random normal(5), advanced(5);
  normal.Normal();
  advanced.Advance(Random::kNumbersOfNormal);
  EXPECT_EQ(normal.Next(), advanced.Next());
}

TEST(Random, DrawsManyNormalNumbersAsItDrawsEachOfThem) {
  Random many(7), each(7);
  std::vector<double> normals(1001);
  many.Normals(normals);
  // The vector forms of the logarithm and the cosine are right to 4 units in the last place; |normal| < 7.
  for (const double normal : normals) ASSERT_NEAR(normal, each.Normal(), 1e-14);
  EXPECT_EQ(many.Next(), each.Next());
}

}  // namespace
}  // namespace citrine

#include "logs/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace citrine::logs {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

ComparedRun RunWith(const std::string& cell, int seed, double makespan_m, const std::string& alpha = "1") {
  ComparedRun run{
      cell, {}, {{"planner.alpha", alpha}, {"mission.world", "'w.sdf'"}, {"launch.out", "'" + cell + "'"}}};
  run.metrics.seed = seed;
  run.metrics.makespan_m = makespan_m;
  run.metrics.log_digest = std::to_string(makespan_m);
  run.metrics.commit = "c0ffee";
  return run;
}

TEST(Comparison, OfARunWithItselfFindsNothing) {
  const std::string text = Compare({RunWith("", 1, 100)}, {RunWith("", 1, 100)});
  EXPECT_THAT(text, HasSubstr("The configuration is the same."));
  EXPECT_THAT(text, HasSubstr("every number is the same"));
  EXPECT_THAT(text, HasSubstr("1 of 1 pairs have the same log digest."));
}

TEST(Comparison, OfTwoRunsNamesTheKeyAndTheNumberAndClaimsNoSignificance) {
  ComparedRun b = RunWith("", 2, 90, "1.5");
  b.metrics.commit = "cafe";
  const std::string text = Compare({RunWith("", 1, 100)}, {b});
  EXPECT_THAT(text, ContainsRegex("planner.alpha +1 +1.5\n"));
  EXPECT_THAT(text, ContainsRegex("makespan_m +100.00 +90.00 +-10.00 +-10.0 % +– +–\n"));
  EXPECT_THAT(text, Not(HasSubstr("mission.world")));
  EXPECT_THAT(text, Not(HasSubstr("launch.out")));
  EXPECT_THAT(text, HasSubstr("Commits: A c0ffee; B cafe."));
  EXPECT_THAT(text, HasSubstr("says nothing about significance"));
}

TEST(Comparison, OfTwoSweepsIsPairedCellByCell) {
  const std::vector<ComparedRun> a = {RunWith("house/x", 1, 100), RunWith("house/x", 2, 200),
                                      RunWith("house/x", 3, 300), RunWith("house/y", 1, 5)};
  const std::vector<ComparedRun> b = {RunWith("house/x", 3, 290), RunWith("house/x", 1, 91),
                                      RunWith("house/x", 2, 189), RunWith("barn/x", 1, 5)};
  const std::string text = Compare(a, b);
  // -9, -11, -10 m: mean -10, deviation 1, t 4.303, 2.48 m either way; t = 17.3, p = 0.0033.
  EXPECT_THAT(
      text, ContainsRegex(
                "makespan_m +200.00 ± 100.00 +190.00 ± 99.50 +-10.00 +-5.0 % +.-12.48, -7.52. +0.0033 .\n"));
  EXPECT_THAT(text, HasSubstr("only in A: house/y seed 1"));
  EXPECT_THAT(text, HasSubstr("only in B: barn/x seed 1"));
}

TEST(Comparison, OfWhatHasNothingInCommonSaysSo) {
  EXPECT_THAT(Compare({RunWith("x", 1, 1), RunWith("x", 2, 1)}, {RunWith("y", 1, 1)}),
              HasSubstr("Nothing of A"));
}

}  // namespace
}  // namespace citrine::logs

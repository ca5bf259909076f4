#include "logs/sweep_tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "logs/metric_number.h"
#include "tests/logs/sweep_of_two.h"

namespace citrine::logs {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(SweepTables, MeansStandAboveThePapersRows) {
  const SweepResults results = SweepOfTwo();
  const TextTable table = MeansTable(results, results.plan.worlds[0]);
  EXPECT_THAT(table.head, ElementsAre("Method", "Completed", "Collisions", "Makespan (m)", "Cov. (%)"));
  ASSERT_EQ(table.rows.size(), 6u);
  EXPECT_THAT(table.rows[0].cells, ElementsAre("a", "3/3", "0", "200.0 ± 100.0", "–"));
  EXPECT_THAT(table.rows[1].cells, ElementsAre("b", "2/3", "2", "176.0 ± 119.6", "–"));
  EXPECT_THAT(table.rows[2].cells, ElementsAre("paper (d* = 4.5 m)", "–", "–", "258.2", "80.73"));
}

TEST(SweepTables, DifferencesArePairedBySeedAndNotTakenBetweenMeans) {
  const SweepResults results = SweepOfTwo();
  const TextTable table = DifferencesTable(results, results.plan.worlds[0]);
  ASSERT_EQ(table.rows.size(), 1u);
  // -10 and -12 m: mean -11, deviation sqrt(2), t of one degree of freedom 12.706: 12.7 m either way.
  EXPECT_THAT(table.rows[0].cells, ElementsAre("b", "2", "−11.0 [−23.7, +1.7]", "–"));
}

TEST(SweepTables, AStarMarksWhatIsSignificant) {
  SweepResults results = SweepOfTwo();
  results.runs.push_back(RunOf("house", "b", 1, 89));
  EXPECT_THAT(DifferencesTable(results, results.plan.worlds[0]).rows[0].cells[2], "−11.0 [−13.5, −8.5] *");
}

TEST(SweepTables, OneSeedHasAMeanAndADifferenceWithoutAnInterval) {
  SweepResults results = SweepOfTwo();
  results.runs = {RunOf("house", "a", 1, 100), RunOf("house", "b", 1, 90)};
  EXPECT_EQ(MeansTable(results, results.plan.worlds[0]).rows[0].cells[3], "100.0");
  EXPECT_EQ(DifferencesTable(results, results.plan.worlds[0]).rows[0].cells[2], "−10.0");
}

TEST(SweepTables, AWorldNotYetFlownHasNone) {
  SweepResults results = SweepOfTwo();
  results.runs.clear();
  EXPECT_TRUE(MeansTable(results, results.plan.worlds[0]).rows.empty());
  EXPECT_TRUE(DifferencesTable(results, results.plan.worlds[0]).rows.empty());
  EXPECT_THAT(SweepMarkdown(results), HasSubstr("Flown in the rain."));
}

TEST(SweepTables, CsvHasALineARunAndALineAMetric) {
  const SweepResults results = SweepOfTwo();
  const std::string runs = RunsCsv(results);
  EXPECT_EQ(std::count(runs.begin(), runs.end(), '\n'), 7);
  EXPECT_THAT(runs, HasSubstr("\nhouse,b,surface_complete,"));
  EXPECT_THAT(SummaryCsv(results), HasSubstr("house,b,makespan_m,3,176.000000,119.616"));
  EXPECT_THAT(SummaryCsv(results), HasSubstr(",2,-11.000000,-23.706205,1.706205,0.057716\n"));
}

TEST(SweepTables, MarkdownAndLatexCarryTheCommand) {
  const SweepResults results = SweepOfTwo();
  EXPECT_THAT(SweepMarkdown(results), HasSubstr("```sh\n./citrine sweep two\n```"));
  EXPECT_THAT(SweepLatex(results), HasSubstr("./citrine sweep two"));
}

TEST(MetricNumber, FindsWhateverIsOneNumber) {
  Metrics metrics;
  metrics.makespan_m = 12.5;
  metrics.collisions = 3;
  metrics.completed = true;
  EXPECT_EQ(MetricNumber(metrics, "makespan_m"), 12.5);
  EXPECT_EQ(MetricNumber(metrics, "collisions"), 3);
  EXPECT_EQ(MetricNumber(metrics, "completed"), 1);
  EXPECT_FALSE(MetricNumber(metrics, "coverage_pct").has_value());
  EXPECT_FALSE(MetricNumber(metrics, "mission").has_value());
  const auto keys = NumberKeys();
  for (const std::string& column : PaperColumns()) EXPECT_THAT(keys, ::testing::Contains(column));
  EXPECT_THAT(keys, ::testing::Not(::testing::Contains("path_m")));
}

}  // namespace
}  // namespace citrine::logs

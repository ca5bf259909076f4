#include "logs/sweep_plots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "logs/progress_csv.h"
#include "logs/svg_chart.h"
#include "logs/sweep_html.h"
#include "tests/logs/sweep_of_two.h"

namespace citrine::logs {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

int CountOf(const std::string& text, const std::string& what) {
  int count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(SweepPlots, MeansOverTimeHoldTheLastValueOfWhatHasEnded) {
  const Series shorter = {{0, 0}, {1, 10}, {2, 20}}, longer = {{0, 0}, {2, 100}, {4, 200}};
  const Series mean = MeanOverTime({&shorter, &longer}, 4);
  const Series expected = {{0, 0}, {1, 5}, {2, 60}, {3, 60}, {4, 110}};
  EXPECT_EQ(mean, expected);
  EXPECT_TRUE(MeanOverTime({}, 4).empty());
}

TEST(SweepPlots, EveryColumnIsDrawnByVariantWithADotARun) {
  const auto figures = SweepFigures(SweepOfTwo());
  ASSERT_EQ(figures.size(), 2u);
  EXPECT_EQ(figures[0].name, "house-makespan_m");
  EXPECT_EQ(CountOf(figures[0].figure.body, "class=\"faint"), 6);
  EXPECT_THAT(figures[0].figure.body, HasSubstr(">paper<"));
}

TEST(SweepPlots, NameVariantsByTheirTitlesWhereTheseAreShort) {
  SweepResults results = SweepOfTwo();
  results.plan.variants[0].title = "d* = 2 m";
  results.plan.variants[1].title = "a title that is too long to stand beside a figure";
  const std::string body = SweepFigures(results)[0].figure.body;
  EXPECT_THAT(body, HasSubstr(">d* = 2 m<"));
  EXPECT_THAT(body, HasSubstr(">b<"));
}

TEST(SweepPlots, AreDrawnOverXWhereTheVariantsHaveOne) {
  SweepResults results = SweepOfTwo();
  results.plan.sweep.x_label = "UAVs";
  results.plan.variants[0].x = 1;
  results.plan.variants[1].x = 2;
  const auto figures = SweepFigures(results);
  EXPECT_EQ(figures[0].name, "house-makespan_m-over_x");
  EXPECT_EQ(CountOf(figures[0].figure.body, "class=\"dot"), 2);
}

TEST(SweepPlots, WhatIsWantedOverTimeIsDrawnOnceAWorld) {
  SweepResults results = SweepOfTwo();
  results.plan.sweep.over_time = {"voxels_at_goal"};
  for (SweepRun& run : results.runs) run.over_time["voxels_at_goal"] = {{0, 0}, {10, 500}};
  const auto figures = SweepFigures(results);
  EXPECT_EQ(figures[0].name, "house-voxels_at_goal-over_time");
  EXPECT_EQ(CountOf(figures[0].figure.body, "<polyline"), 2);
}

TEST(SweepPlots, AFileHoldsItsColoursAndItsLegend) {
  const std::string svg =
      ToSvgFile(LineFigure({"A & B", "t", "y"}, {{"one", {{0, 0}, {1, 1}}, 0}, {"two", {{0, 1}}, 1}}));
  EXPECT_THAT(svg, HasSubstr("xmlns=\"http://www.w3.org/2000/svg\""));
  for (const char* text : {"A &amp; B", ">one<", ">two<", "--c1:"}) EXPECT_THAT(svg, HasSubstr(text));
}

TEST(SweepPlots, IntervalsReachAsFarAsTheyAreWide) {
  Curve curve{"", {{1, 50}, {2, 80}}, 0, false, {10, 40}};
  // The axis has to hold 120 and ends at 150, 188 pixels above y = 200; 40 and 120 are 50.1 and 150.4 of
  // them.
  const SvgFigure figure = LineFigure({"", "", ""}, {curve});
  EXPECT_THAT(figure.body, HasSubstr("y1=\"149.9\" x2=\"448.0\" y2=\"49.6\""));
  EXPECT_EQ(CountOf(figure.body, "class=\"dot"), 2);
}

TEST(SweepHtml, NeedsNothingFromOutside) {
  const SweepResults results = SweepOfTwo();
  const std::string html = SweepHtml(results, SweepFigures(results));
  for (const char* outside : {"src=\"http", "href=", "<script", "@import", "url("})
    EXPECT_THAT(html, Not(HasSubstr(outside)));
  for (const char* inside : {"./citrine sweep two", "Flown in the rain.", "176.0 ± 119.6", "<svg"})
    EXPECT_THAT(html, HasSubstr(inside));
}

TEST(ProgressCsv, AColumnIsReadOverTime) {
  const std::string csv = "time_s,a,b\n0.5,1,2\n1.0,3,4\n";
  const Series expected = {{0.5, 2}, {1, 4}};
  EXPECT_EQ(ColumnOverTime(csv, "b"), expected);
  EXPECT_THROW(ColumnOverTime(csv, "c"), std::runtime_error);
  EXPECT_THROW(ColumnOverTime("time_s,a,b\n0.5,1\n", "b"), std::runtime_error);
  EXPECT_THROW(ColumnOverTime("", "b"), std::runtime_error);
}

}  // namespace
}  // namespace citrine::logs

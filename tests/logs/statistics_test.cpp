#include "logs/statistics.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "core/random.h"

namespace citrine::logs {
namespace {

/// P(|T| > t) by Simpson's rule over the density, whose normalisation is integrated as well.
double IntegratedTail(double t, double nu) {
  const auto density = [&](double x) { return std::pow(1 + x * x / nu, -(nu + 1) / 2); };
  // x = tan(u) maps the line to (-pi/2, pi/2); dx = (1 + x^2) du.
  const auto mapped = [&](double u) { return density(std::tan(u)) * (1 + std::tan(u) * std::tan(u)); };
  const auto integral = [&](double from, double to) {
    constexpr int kSteps = 20000;
    double sum = 0;
    const double h = (to - from) / kSteps;
    for (int k = 0; k < kSteps; ++k)
      sum += h / 6 * (mapped(from + k * h) + 4 * mapped(from + (k + 0.5) * h) + mapped(from + (k + 1) * h));
    return sum;
  };
  const double end = std::numbers::pi / 2 - 1e-9;
  return integral(std::atan(t), end) / integral(0, end);
}

TEST(Statistics, StudentsTailIsTheIntegralOfItsDensity) {
  for (const double nu : {1.0, 2.0, 4.0, 9.0, 29.0})
    for (const double t : {0.1, 1.0, 2.5, 6.0})
      EXPECT_NEAR(StudentTail(t, nu), IntegratedTail(t, nu), 1e-7) << nu << " " << t;  // the cut at infinity
  EXPECT_EQ(StudentTail(INFINITY, 3), 0);
}

TEST(Statistics, StudentsQuantileInvertsTheTail) {
  for (const double nu : {1.0, 2.0, 9.0})
    for (const double p : {0.5, 0.05, 0.001}) EXPECT_NEAR(StudentTail(StudentQuantile(p, nu), nu), p, 1e-10);
  EXPECT_NEAR(StudentQuantile(0.05, 1), std::tan(0.95 * std::numbers::pi / 2), 1e-9);  // Cauchy
  EXPECT_NEAR(StudentQuantile(0.05, 2), 0.95 * std::sqrt(2 / (1 - 0.95 * 0.95)), 1e-9);
}

TEST(Statistics, MeanDeviationAndIntervalOfAHandfulAreThoseOfHandReckoning) {
  const Summary s = Summarise({2, 4, 9});
  EXPECT_EQ(s.count, 3u);
  EXPECT_DOUBLE_EQ(s.mean, 5);
  EXPECT_DOUBLE_EQ(s.deviation, std::sqrt((9 + 1 + 16) / 2.0));
  EXPECT_NEAR(s.half_width, 4.30265273 * s.deviation / std::sqrt(3.0), 1e-7);
}

TEST(Statistics, OneValueHasAMeanAloneAndNoneHasNothing) {
  EXPECT_EQ(Summarise({3}).mean, 3);
  EXPECT_TRUE(std::isnan(Summarise({3}).deviation));
  EXPECT_TRUE(std::isnan(Summarise({3}).half_width));
  EXPECT_TRUE(std::isnan(Summarise({}).mean));
  EXPECT_FALSE(Pair({1}, {2}).significant());
  EXPECT_TRUE(std::isnan(Pair({1}, {2}).p));
}

TEST(Statistics, PairsFindASmallDifferenceUnderALargeSpread) {
  const std::vector<double> a = {100, 200, 300, 400, 500};
  const PairedDifference pair = Pair(a, {101.1, 200.9, 301, 401.2, 500.8});
  EXPECT_NEAR(pair.difference.mean, 1, 1e-9);
  EXPECT_LT(pair.p, 0.001);
  EXPECT_TRUE(pair.significant());
  EXPECT_FALSE(Pair(a, {150, 120, 390, 310, 530}).significant());
}

TEST(Statistics, EqualPairsDoNotDifferAndAConstantShiftIsCertain) {
  EXPECT_EQ(Pair({1, 2, 3}, {1, 2, 3}).p, 1);
  EXPECT_EQ(Pair({1, 2, 3}, {2, 3, 4}).p, 0);
}

TEST(Statistics, TheIntervalHoldsTheTruthNineteenTimesOfTwenty) {
  Random random(5);
  constexpr int kTrials = 4000;
  int held = 0, false_alarms = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> a, b;
    for (int k = 0; k < 5; ++k) a.push_back(random.Normal()), b.push_back(random.Normal() + 0.3);
    const Summary d = Pair(a, b).difference;
    held += std::abs(d.mean - 0.3) < d.half_width;
    for (double& value : b) value -= 0.3;
    false_alarms += Pair(a, b).significant();
  }
  // Binomial of 4000 trials: a standard deviation of 14; four of them.
  EXPECT_NEAR(held, 0.95 * kTrials, 56);
  EXPECT_NEAR(false_alarms, 0.05 * kTrials, 56);
}

}  // namespace
}  // namespace citrine::logs

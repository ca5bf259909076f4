#include "logs/statistics.h"

#include <cmath>
#include <limits>

#include <boost/math/distributions/students_t.hpp>

namespace citrine::logs {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kOutside = 0.05;  ///< of a 95 % interval

}  // namespace

double StudentQuantile(double p, double degrees_of_freedom) {
  return boost::math::quantile(boost::math::complement(boost::math::students_t(degrees_of_freedom), p / 2));
}

double StudentTail(double t, double degrees_of_freedom) {
  if (std::isinf(t)) return 0;
  return 2 *
         boost::math::cdf(boost::math::complement(boost::math::students_t(degrees_of_freedom), std::abs(t)));
}

Summary Summarise(const std::vector<double>& values) {
  Summary summary{values.size(), kNone, kNone, kNone};
  if (values.empty()) return summary;
  const double n = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (const double value : values) sum += value;
  summary.mean = sum / n;
  if (values.size() < 2) return summary;
  for (const double value : values) squares += (value - summary.mean) * (value - summary.mean);
  summary.deviation = std::sqrt(squares / (n - 1));
  summary.half_width = StudentQuantile(kOutside, n - 1) * summary.deviation / std::sqrt(n);
  return summary;
}

PairedDifference Pair(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(b[i] - a[i]);
  PairedDifference pair{Summarise(differences), kNone};
  const Summary& d = pair.difference;
  if (d.count < 2) return pair;
  const double n = static_cast<double>(d.count);
  if (d.deviation == 0)
    pair.p = d.mean == 0 ? 1 : 0;
  else
    pair.p = StudentTail(d.mean / (d.deviation / std::sqrt(n)), n - 1);
  return pair;
}

}  // namespace citrine::logs

#pragma once

#include <cstddef>
#include <vector>

namespace citrine::logs {

/// Mean and deviation of a sample.
struct Summary {
  std::size_t count = 0;
  double mean = 0;        ///< NaN of nothing
  double deviation = 0;   ///< with n - 1; NaN below two
  double half_width = 0;  ///< of the 95 % confidence interval of the mean, Student's t; NaN below two
};
Summary Summarise(const std::vector<double>& values);

/// How much larger `b` is than `a`, pair by pair: the paired t test (Student 1908).
struct PairedDifference {
  Summary difference;  ///< of b - a
  double p = 1;        ///< two-sided, of no difference; NaN below two pairs

  bool significant() const { return p < 0.05; }
};
/// @param a, b of the same length; pairs stand at the same index
PairedDifference Pair(const std::vector<double>& a, const std::vector<double>& b);

/// The value that Student's t of `degrees_of_freedom` exceeds in size with a probability of `p`, two-sided.
double StudentQuantile(double p, double degrees_of_freedom);

/// The probability that it exceeds `t` in size.
double StudentTail(double t, double degrees_of_freedom);

}  // namespace citrine::logs

#include "logs/percentile.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace citrine::logs {

std::optional<double> Percentile(std::vector<float> samples, double percent) {
  if (samples.empty()) return std::nullopt;
  const double rank = std::clamp(percent, 0.0, 100.0) / 100 * static_cast<double>(samples.size() - 1);
  const auto below = static_cast<std::ptrdiff_t>(std::floor(rank));
  std::nth_element(samples.begin(), samples.begin() + below, samples.end());
  const double low = samples[below];
  if (rank == static_cast<double>(below)) return low;
  const double high = *std::min_element(samples.begin() + below + 1, samples.end());
  return low + (rank - static_cast<double>(below)) * (high - low);
}

}  // namespace citrine::logs

#pragma once

#include <optional>
#include <vector>

namespace citrine::logs {

/// The value below which `percent` of the samples lie, linear between ranks; nothing if there is no sample.
std::optional<double> Percentile(std::vector<float> samples, double percent);

}  // namespace citrine::logs

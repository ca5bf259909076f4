#pragma once

#include <optional>
#include <string>

namespace citrine::logs {

/// A number with a fixed count of decimals and a point, whatever the locale.
std::string Fixed(double value, int decimals);
/// As above; an en dash for nothing.
std::string Fixed(const std::optional<double>& value, int decimals);

/// Minutes and seconds, "4:49".
std::string MinutesSeconds(double seconds);

/// 1.5 kB, 12.3 MB, ... (powers of 1000).
std::string Bytes(double bytes);

}  // namespace citrine::logs

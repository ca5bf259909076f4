#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

namespace citrine {

/// A message that decoded but means nothing; its hearer counts it (Bus::Reject) and drops it.
struct BadMessage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// @throws BadMessage(what) unless `holds`
inline void Require(bool holds, const char* what) {
  if (!holds) throw BadMessage(what);
}

/// @throws BadMessage(what) unless every value is a finite number
template <class... Values>
void RequireFinite(const char* what, const Values&... values) {
  Require((std::isfinite(static_cast<double>(values)) && ...), what);
}

}  // namespace citrine

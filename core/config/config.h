#pragma once

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace citrine {

/// What a configuration key allows and where its default comes from; shown by `citrine config`.
struct Key {
  const char* doc = "";   ///< what it is and what it changes, with the source of the default
  const char* unit = "";  ///< "m", "s", "rad", ... ; empty for a count or a name
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  std::vector<std::string> options = {};  ///< of a name; empty: any
};

/// A configuration that cannot be used: one line with the key's full path, the value and what is allowed.
struct ConfigError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace citrine

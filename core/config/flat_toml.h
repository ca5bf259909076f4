#pragma once

#include <map>
#include <string>

namespace citrine {

/// The values of a TOML text by their whole path, such as "planner.alpha" or "quality.region[0].d_star_m", as
/// TOML has them; lists are one value. @throws ConfigError for text that is not TOML
std::map<std::string, std::string> FlattenToml(const std::string& toml_text);

}  // namespace citrine

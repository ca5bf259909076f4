#include "core/config/flat_toml.h"

#include "core/config/toml_section.h"

namespace citrine {
namespace {

void Flatten(const std::string& path, const toml::node& node, std::map<std::string, std::string>& values) {
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table)
      Flatten((path.empty() ? "" : path + ".") + std::string(key.str()), value, values);
  } else if (node.is_array_of_tables()) {
    std::size_t row = 0;
    for (const toml::node& value : *node.as_array())
      Flatten(path + "[" + std::to_string(row++) + "]", value, values);
  } else {
    values[path] = TextOf(node);
  }
}

}  // namespace

std::map<std::string, std::string> FlattenToml(const std::string& toml_text) {
  std::map<std::string, std::string> values;
  Flatten("", ParseToml(toml_text), values);
  return values;
}

}  // namespace citrine

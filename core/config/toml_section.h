#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "core/config/value_kind.h"

namespace citrine {

// How a table of a TOML file is read into a struct whose `Visit` names its fields; the readers of mission and
// of sweep files are made of it. All throw ConfigError naming the key's path.

inline std::string TextOf(const toml::node& node) {
  std::ostringstream out;
  out << toml::node_view<const toml::node>(node);
  return out.str();
}

[[noreturn]] inline void Refuse(const std::string& path, const std::string& allowed, const toml::node& node) {
  throw ConfigError(path + ": must be " + allowed + ", is " + TextOf(node));
}

// Read() takes over a node of the right type; false otherwise.
inline bool Read(const toml::node& node, bool& value) {
  return node.is_boolean() && (value = node.as_boolean()->get(), true);
}
inline bool Read(const toml::node& node, double& value) {
  if (!node.is_number()) return false;
  value = *node.value<double>();
  return std::isfinite(value);
}
inline bool Read(const toml::node& node, int& value) {
  if (!node.is_integer()) return false;
  const std::int64_t wide = node.as_integer()->get();
  value = static_cast<int>(wide);
  return value == wide;
}
inline bool Read(const toml::node& node, std::string& value) {
  return node.is_string() && (value = node.as_string()->get(), true);
}
inline bool Read(const toml::node& node, Eigen::Vector3d& value) {
  const toml::array* array = node.as_array();
  return array && array->size() == 3 && Read(*array->get(0), value.x()) && Read(*array->get(1), value.y()) &&
         Read(*array->get(2), value.z());
}
template <class T>
bool Read(const toml::node& node, std::vector<T>& values) {
  const toml::array* array = node.as_array();
  if (!array) return false;
  values.assign(array->size(), T{});
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!Read(*array->get(i), values[i])) return false;
  return true;
}
template <class T>
bool Read(const toml::node& node, std::optional<T>& value) {
  return Read(node, value.emplace());
}

template <class T>
bool InRange(const T& value, const Key& key) {
  if constexpr (std::is_same_v<T, int> || std::is_same_v<T, double>)
    return value >= key.min && value <= key.max;
  return true;
}
inline bool InRange(const std::string& value, const Key& key) {
  return key.options.empty() || std::find(key.options.begin(), key.options.end(), value) != key.options.end();
}

/// Names of the fields of one section, and which of them are texts.
struct FieldNames {
  std::vector<std::string> all, texts;

  template <class T>
  void operator()(const char* name, const T&, const Key&) {
    all.push_back(name);
    if constexpr (std::is_same_v<T, std::string>) texts.push_back(name);
  }
};

/// Whether a name is among others.
inline bool Contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

struct FieldReader {
  const toml::table& table;
  std::string path;

  template <class T>
  void operator()(const char* name, T& value, const Key& key) {
    const toml::node* node = table.get(name);
    if (!node) return;
    if (!Read(*node, value) || !InRange(value, key)) Refuse(path + name, Allowed(value, key), *node);
  }
};

template <class Section>
void ReadSection(const toml::table& table, const std::string& path, Section& section) {
  FieldReader reader{table, path + "."};
  section.Visit(reader);
}

/// @throws ConfigError with line and column
inline toml::table ParseToml(const std::string& text) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& error) {
    const auto& at = error.source().begin;
    throw ConfigError(std::to_string(at.line) + ":" + std::to_string(at.column) +
                      ": not TOML: " + std::string(error.description()));
  }
}

}  // namespace citrine

#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/config/config.h"
#include "core/config/number_text.h"

namespace citrine {

// What a key of each kind is called and what it allows, in words; one overload a kind of field.

inline std::string RangeText(const Key& key) {
  const bool lower = std::isfinite(key.min), upper = std::isfinite(key.max);
  if (lower && upper) return "[" + NumberText(key.min) + ", " + NumberText(key.max) + "]";
  if (lower) return ">= " + NumberText(key.min);
  if (upper) return "<= " + NumberText(key.max);
  return "";
}

inline std::string OptionsText(const Key& key) {
  std::string text;
  for (const std::string& option : key.options) text += (text.empty() ? "" : " | ") + option;
  return text;
}

inline std::string Allowed(bool, const Key&) { return "true or false"; }
inline std::string Allowed(int, const Key& key) {
  return "an integer" + (RangeText(key).empty() ? "" : " in " + RangeText(key));
}
inline std::string Allowed(double, const Key& key) {
  return "a number" + (RangeText(key).empty() ? "" : " in " + RangeText(key));
}
inline std::string Allowed(const std::string&, const Key& key) {
  return key.options.empty() ? "a text in quotes" : "one of " + OptionsText(key);
}
inline std::string Allowed(const Eigen::Vector3d&, const Key&) { return "three numbers [x, y, z]"; }
inline std::string Allowed(const std::vector<Eigen::Vector3d>&, const Key&) { return "a list of [x, y, z]"; }
inline std::string Allowed(const std::vector<std::string>&, const Key&) {
  return "a list of texts in quotes";
}
inline std::string Allowed(const std::vector<int>&, const Key&) { return "a list of integers"; }
template <class T>
std::string Allowed(const std::optional<T>&, const Key& key) {
  return Allowed(T{}, key);
}

}  // namespace citrine

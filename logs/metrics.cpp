#include "logs/metrics.h"

#include <cmath>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace citrine::logs {
namespace {

using Json = nlohmann::ordered_json;

/// Six decimals, so that the file can be read by eyes; null for what is not finite.
Json Rounded(double x) {
  if (!std::isfinite(x)) return nullptr;
  const double rounded = std::round(x * 1e6) / 1e6;
  return rounded == 0 ? 0.0 : rounded;
}

struct Writer {
  Json json = Json::object();

  void operator()(const std::string& key, double value) {
    json[key] = key == "pace" && value == 0 ? Json("max") : Rounded(value);
  }
  void operator()(const std::string& key, const std::vector<double>& values) {
    json[key] = Json::array();
    for (const double value : values) json[key].push_back(Rounded(value));
  }
  void operator()(const std::string& key, const std::map<std::string, std::int64_t>& values) {
    json[key] = Json::object();
    for (const auto& [name, value] : values) json[key][name] = value;
  }
  template <class T>
  void operator()(const std::string& key, const std::optional<T>& value) {
    if (value)
      (*this)(key, *value);
    else
      json[key] = nullptr;
  }
  template <class T>
  void operator()(const std::string& key, const T& value) {
    json[key] = value;
  }
};

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

struct Reader {
  const Json& json;

  template <class T>
  void operator()(const std::string& key, T& value) {
    const auto found = json.find(key);
    if (found == json.end() || found->is_null()) return;
    try {
      if constexpr (IsOptional<T>::value)
        value = found->template get<typename T::value_type>();
      else
        value = found->template get<T>();
    } catch (const Json::exception&) {
      throw std::runtime_error("metrics.json: " + key + ": unexpected value " + found->dump());
    }
  }
  void operator()(const std::string& key, double& value) {
    const auto found = json.find(key);
    if (key == "pace" && found != json.end() && *found == "max")
      value = 0;
    else
      operator()<double>(key, value);
  }
};

}  // namespace

std::string ToJson(const Metrics& metrics) {
  Writer writer;
  Metrics copy = metrics;
  copy.Visit(writer);
  return writer.json.dump(2) + "\n";
}

Metrics MetricsFromJson(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) throw std::runtime_error("metrics.json: not a JSON object");
  Metrics metrics;
  Reader reader{json};
  metrics.Visit(reader);
  return metrics;
}

}  // namespace citrine::logs

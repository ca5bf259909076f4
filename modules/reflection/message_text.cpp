#include "modules/reflection/message_text.h"

#include <algorithm>
#include <cmath>

#include "core/config/number_text.h"

namespace citrine {
namespace {

constexpr std::size_t kMostValues = 12;  // of an array, on a line

std::string Text(std::int64_t value) { return std::to_string(value); }
std::string Text(double value) { return NumberText(value); }

std::string Json(std::int64_t value) { return std::to_string(value); }
std::string Json(double value) { return std::isfinite(value) ? NumberText(value) : "null"; }
std::string Json(const std::string& value) { return JsonText(value); }

template <class Value>
std::string Line(const std::vector<Value>& values) {
  std::string line;
  for (std::size_t i = 0; i < std::min(values.size(), kMostValues); ++i) line += "  " + Text(values[i]);
  if (values.size() > kMostValues) line += "  ... " + std::to_string(values.size()) + " values";
  if (values.empty()) line = "  none";
  return line;
}
std::string Line(const std::vector<std::uint8_t>& bytes) {
  return "  " + std::to_string(bytes.size()) + " bytes";
}

/// Texts of several lines, such as a mission file, stand as they are.
std::string Line(const std::vector<std::string>& texts) {
  std::string line;
  for (const std::string& text : texts) {
    if (text.find('\n') == std::string::npos) {
      line += "  " + JsonText(text);
      continue;
    }
    for (std::size_t at = 0, end; at < text.size(); at = end + 1) {
      end = std::min(text.find('\n', at), text.size());
      line += "\n    | " + text.substr(at, end - at);
    }
  }
  return texts.empty() ? "  none" : line;
}

std::string NameOfConstant(const MessageType& type, const FieldValues& field) {
  if (!field.type->dimensions.empty()) return {};
  for (const ConstantType& constant : type.constants)
    if (constant.kind == field.type->kind && constant.value == field.integer()) return "  " + constant.name;
  return {};
}

template <class Value>
std::string JsonValues(const std::vector<Value>& values, bool array) {
  if (!array) return Json(values.front());
  std::string text;
  for (const Value& value : values) text += (text.empty() ? "" : ",") + Json(value);
  return "[" + text + "]";
}
std::string JsonValues(const std::vector<std::uint8_t>& bytes, bool) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : bytes) (text += kDigits[byte >> 4]) += kDigits[byte & 15];
  return "\"" + text + "\"";
}

}  // namespace

std::string ToText(const MessageType& type, const std::vector<FieldValues>& fields) {
  std::string text;
  for (const FieldValues& field : fields) {
    text += "  " + field.type->name + (field.type->unit.empty() ? "" : " [" + field.type->unit + "]");
    text += std::visit([](const auto& values) { return Line(values); }, field.values);
    text += NameOfConstant(type, field) + "\n";
  }
  return text;
}

std::string ToJsonMembers(const std::vector<FieldValues>& fields) {
  std::string text;
  for (const FieldValues& field : fields) {
    const bool array = !field.type->dimensions.empty();
    text += (text.empty() ? "" : ",") + JsonText(field.type->name) + ":" +
            std::visit([&](const auto& values) { return JsonValues(values, array); }, field.values);
  }
  return text;
}

std::string JsonText(const std::string& text) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      (quoted += '\\') += c;
    else if (c == '\n')
      quoted += "\\n";
    else if (code < 0x20)
      ((quoted += "\\u00") += kDigits[code >> 4]) += kDigits[code & 15];
    else
      quoted += c;
  }
  return quoted + "\"";
}

}  // namespace citrine

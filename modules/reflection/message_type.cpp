#include "modules/reflection/message_type.h"

#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace citrine {
namespace {

using Kind = FieldType::Kind;

Kind KindOfName(const std::string& name) {
  static const std::map<std::string, Kind> kinds = {
      {"int8_t", Kind::kInt8},   {"int16_t", Kind::kInt16}, {"int32_t", Kind::kInt32},
      {"int64_t", Kind::kInt64}, {"byte", Kind::kByte},     {"boolean", Kind::kBoolean},
      {"float", Kind::kFloat},   {"double", Kind::kDouble}, {"string", Kind::kString}};
  const auto kind = kinds.find(name);
  if (kind == kinds.end()) throw std::invalid_argument("no plain type of LCM: " + name);
  return kind->second;
}

std::vector<std::string> DimensionsOf(const std::string& brackets) {
  static const std::regex dimension(R"(\[\s*(\w+)\s*\])");
  std::vector<std::string> dimensions;
  for (std::sregex_iterator it(brackets.begin(), brackets.end(), dimension), end; it != end; ++it)
    dimensions.push_back((*it)[1]);
  return dimensions;
}

}  // namespace

MessageType ParseMessageType(std::string_view lcm_text) {
  static const std::regex nothing(R"(\s*(//.*)?|package\s+\w+\s*;.*|\s*[{}]\s*)"),
      head(R"(struct\s+(\w+)\s*\{?\s*)"),
      field(R"(\s*(\w+)\s+(\w+)\s*((\[\s*\w+\s*\]\s*)*);\s*(//\s*(\[([^\]]*)\])?.*)?)"),
      constant(R"(\s*const\s+(int\d+_t)\s+(\w+)\s*=\s*(-?\d+)\s*;.*)");
  MessageType type;
  std::istringstream lines{std::string(lcm_text)};
  for (std::string line; std::getline(lines, line);) {
    std::smatch m;
    if (std::regex_match(line, nothing)) continue;
    if (std::regex_match(line, m, head))
      type.name = m[1];
    else if (std::regex_match(line, m, constant))
      type.constants.push_back({m[2], KindOfName(m[1]), std::stoll(m[3])});
    else if (std::regex_match(line, m, field))
      type.fields.push_back({m[2], KindOfName(m[1]), DimensionsOf(m[3]), m[7] == "-" ? "" : m[7].str()});
    else
      throw std::invalid_argument("neither a field nor a constant of LCM: " + line);
  }
  if (type.name.empty()) throw std::invalid_argument("no struct in an .lcm file");
  return type;
}

}  // namespace citrine

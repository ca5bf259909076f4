#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace citrine {

/// One field of a message type, as its .lcm file declares it.
struct FieldType {
  enum class Kind { kInt8, kInt16, kInt32, kInt64, kByte, kBoolean, kFloat, kDouble, kString };

  std::string name;
  Kind kind = Kind::kInt8;
  std::vector<std::string> dimensions;  ///< of an array: numbers, or names of fields before it
  std::string unit;  ///< what its comment begins with in brackets, such as "m/s"; empty without

  bool operator==(const FieldType&) const = default;
};

/// A constant of a type, such as RUNNING = 0.
struct ConstantType {
  std::string name;
  FieldType::Kind kind = FieldType::Kind::kInt8;
  std::int64_t value = 0;

  bool operator==(const ConstantType&) const = default;
};

/// What a message type holds, for tools that show any message without knowing its type.
struct MessageType {
  std::string name;  ///< without the package, such as "clock_t"
  std::vector<FieldType> fields;
  std::vector<ConstantType> constants;  ///< integers alone
  std::int64_t fingerprint = 0;         ///< with which every message begins; 0 until somebody fills it in
};

/// Reads what an .lcm file declares: one struct of plain fields, as all types of this project are.
/// @throws std::invalid_argument naming the line that it does not know
MessageType ParseMessageType(std::string_view lcm_text);

}  // namespace citrine

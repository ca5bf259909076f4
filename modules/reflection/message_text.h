#pragma once

#include <string>
#include <vector>

#include "modules/reflection/message_fields.h"

namespace citrine {

/// A message for people: one line a field, "  p_WB [m]  1.25  0  2.5"; long arrays are cut, bytes counted,
/// and a value that is one of the type's constants is named.
std::string ToText(const MessageType& type, const std::vector<FieldValues>& fields);

/// A message for programs, whole, in one line of JSON without its braces: "\"utime\":20000,\"seq\":1". Bytes
/// are hexadecimal text; numbers that JSON does not have are null.
std::string ToJsonMembers(const std::vector<FieldValues>& fields);

/// A text in quotation marks, escaped as JSON asks.
std::string JsonText(const std::string& text);

}  // namespace citrine

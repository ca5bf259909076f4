#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "modules/runtime/log_event.h"

namespace citrine {

/// One number or text of a message, such as "p_WB[2]".
struct MessageField {
  std::string name;
  std::variant<std::int64_t, double, std::string> value;

  std::string ValueText() const;
};

/// Every field of a message, arrays element by element, as the .lcm file has them; the codes of MAP_BLOCKS
/// unpacked. Empty for what does not decode.
std::vector<MessageField> FieldsOf(const LogEvent& event);

/// As above, but a trajectory by where it leads: positions every half second for four, beginning at `from`.
/// Its coefficients depend on the step in which it was planned; its positions hardly do.
std::vector<MessageField> MotionOf(const LogEvent& event, Utime from);

}  // namespace citrine

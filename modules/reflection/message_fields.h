#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "modules/reflection/message_type.h"

namespace citrine {

/// What one field of a message holds: its values in the order in which they travel, one where it is no array.
struct FieldValues {
  using Values = std::variant<std::vector<std::int64_t>,   ///< integers and booleans
                              std::vector<double>,         ///< float and double
                              std::vector<std::string>,    ///< string
                              std::vector<std::uint8_t>>;  ///< byte

  const FieldType* type;
  Values values;

  std::size_t size() const {
    return std::visit([](const auto& v) { return v.size(); }, values);
  }
  /// The one value of a field of integers, else 0.
  std::int64_t integer() const;
  /// The one value of a field of text, else "".
  std::string text() const;
};

/// Takes a message apart by what its type declares; the result lives no longer than `type`.
/// @throws BadMessage if it is of another type, cut short, too long, or counts what cannot be
std::vector<FieldValues> ReadFields(const MessageType& type, std::span<const std::uint8_t> message);

/// Who of several senders on a channel said a message, such as "view_planner/2"; empty where one speaks there
/// (as SenderOf in modules/runtime/seq_track.h).
std::string SenderOf(const std::vector<FieldValues>& fields);

}  // namespace citrine

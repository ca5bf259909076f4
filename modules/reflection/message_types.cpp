#include "modules/reflection/message_types.h"

#include <algorithm>

#include "modules/reflection/type_sources.h"

namespace citrine {

const std::vector<MessageType>& MessageTypes() {
  static const std::vector<MessageType> types = [] {
    std::vector<MessageType> parsed;
    for (const TypeSource& source : TypeSources()) {
      parsed.push_back(ParseMessageType(source.lcm_text));
      parsed.back().fingerprint = source.fingerprint;
    }
    return parsed;
  }();
  return types;
}

const MessageType* TypeOf(std::span<const std::uint8_t> message) {
  if (message.size() < 8) return nullptr;
  std::uint64_t fingerprint = 0;
  for (std::size_t i = 0; i < 8; ++i) fingerprint = fingerprint << 8 | message[i];
  const auto& types = MessageTypes();
  const auto type = std::find_if(types.begin(), types.end(), [&](const MessageType& t) {
    return static_cast<std::uint64_t>(t.fingerprint) == fingerprint;
  });
  return type == types.end() ? nullptr : &*type;
}

}  // namespace citrine

#pragma once

#include <span>
#include <vector>

#include "modules/reflection/message_type.h"

namespace citrine {

/// Every type in lcmtypes/, with its fingerprint; made from these files at build time.
const std::vector<MessageType>& MessageTypes();

/// The type of a message, by the fingerprint that it begins with. @return nullptr for one that is not ours
const MessageType* TypeOf(std::span<const std::uint8_t> message);

}  // namespace citrine

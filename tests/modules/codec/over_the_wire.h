#pragma once

#include <cstdint>
#include <vector>

namespace citrine {

/// The message as a hearer gets it: encoded to bytes and decoded from them.
template <class Message>
Message OverTheWire(const Message& message) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  Message heard{};
  heard.decode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return heard;
}

}  // namespace citrine

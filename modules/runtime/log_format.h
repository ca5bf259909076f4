#pragma once

#include <cstddef>
#include <cstdint>

/// LCM's log format: per event, big-endian, sync word, int64 event number, int64 microseconds, uint32 length
/// of the channel, uint32 length of the data; then the channel, without a zero, and the data.
namespace citrine::log_format {

inline constexpr std::uint32_t kSync = 0xEDA1DA01;
inline constexpr std::size_t kHeaderBytes = 28;
inline constexpr std::uint32_t kMaxChannelBytes = 63;     // LCM's own limit
inline constexpr std::uint32_t kMaxDataBytes = 1u << 24;  // beyond any message: a damaged header

}  // namespace citrine::log_format

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace citrine {

/// zstd, level 1: the same bytes in, the same bytes out, for one version of the library.
std::vector<std::uint8_t> Pack(std::span<const std::uint8_t> bytes);

/// @throws BadMessage(what) unless `packed` unpacks to exactly `size` bytes
std::vector<std::uint8_t> Unpack(const std::vector<std::uint8_t>& packed, std::size_t size, const char* what);

}  // namespace citrine

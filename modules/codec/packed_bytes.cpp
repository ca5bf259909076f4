#include "modules/codec/packed_bytes.h"

#include <stdexcept>

#include <zstd.h>

#include "modules/codec/bad_message.h"

namespace citrine {

std::vector<std::uint8_t> Pack(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint8_t> packed(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), 1);
  if (ZSTD_isError(size)) throw std::runtime_error(ZSTD_getErrorName(size));
  packed.resize(size);
  return packed;
}

std::vector<std::uint8_t> Unpack(const std::vector<std::uint8_t>& packed, std::size_t size,
                                 const char* what) {
  Require(ZSTD_getFrameContentSize(packed.data(), packed.size()) == size, what);
  std::vector<std::uint8_t> bytes(size);
  Require(ZSTD_decompress(bytes.data(), size, packed.data(), packed.size()) == size, what);
  return bytes;
}

}  // namespace citrine

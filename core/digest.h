#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace citrine {

/// XXH64 over a stream of bytes; equal on every machine.
class Digest {
 public:
  Digest();
  ~Digest();
  Digest(const Digest&) = delete;
  Digest& operator=(const Digest&) = delete;
  void Add(const void* data, std::size_t size);
  std::uint64_t value() const;

 private:
  void* state_;
};

/// 16 lower-case hexadecimal digits.
std::string Hex(std::uint64_t value);

}  // namespace citrine

#include "core/digest.h"

#include <cstdio>
#include <new>

#include <xxhash.h>

namespace citrine {

Digest::Digest() : state_(XXH64_createState()) {
  if (!state_) throw std::bad_alloc();
  XXH64_reset(static_cast<XXH64_state_t*>(state_), 0);
}
Digest::~Digest() { XXH64_freeState(static_cast<XXH64_state_t*>(state_)); }
void Digest::Add(const void* data, std::size_t size) {
  XXH64_update(static_cast<XXH64_state_t*>(state_), data, size);
}
std::uint64_t Digest::value() const { return XXH64_digest(static_cast<const XXH64_state_t*>(state_)); }

std::string Hex(std::uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
  return text;
}

}  // namespace citrine

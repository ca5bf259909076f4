#pragma once

#include <cstdint>
#include <vector>

namespace citrine {

/// One file of lcmtypes/, and what lcm-gen made its fingerprint.
struct TypeSource {
  std::int64_t fingerprint;
  const char* lcm_text;
};

/// All of them. The build writes its body (cmake/LcmTypes.cmake).
std::vector<TypeSource> TypeSources();

}  // namespace citrine

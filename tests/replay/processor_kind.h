#pragma once

#include <fstream>
#include <string>

#include <gnu/libc-version.h>

#include "core/digest.h"

namespace citrine::test {

/// What decides how numbers are rounded here: the processor and its abilities, the C library that chooses its
/// functions by them, and the compiler.
inline std::string ProcessorKind() {
  std::string model, flags;
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line) && !line.empty();) {
    if (line.starts_with("model name")) model = line.substr(line.find(':') + 2);
    if (line.starts_with("flags")) flags = line;
  }
  Digest digest;
  digest.Add(flags.data(), flags.size());
  return model + ", flags " + Hex(digest.value()) + ", libc " + gnu_get_libc_version() + ", GCC " +
         __VERSION__;
}

}  // namespace citrine::test

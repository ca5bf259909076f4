#include "core/random.h"

#include <algorithm>
#include <array>

namespace citrine {

// Compiled with -ffast-math, for which the loop over both functions becomes one over their vector forms. That
// is why the formula of Normal() stands here again: a function shared with it could be linked as compiled
// here.
void Random::Normals(std::span<double> normals) {
  constexpr std::size_t kTogether = 64;
  std::array<double, kTogether> u, turn;
  while (!normals.empty()) {
    const std::size_t count = std::min(kTogether, normals.size());
    for (std::size_t i = 0; i < count; ++i) {
      u[i] = (Next() + 1.0) * 0x1p-32;
      turn[i] = Uniform();
    }
    for (std::size_t i = 0; i < count; ++i)
      normals[i] = std::sqrt(-2 * std::log(u[i])) * std::cos(6.283185307179586 * turn[i]);
    normals = normals.subspan(count);
  }
}

}  // namespace citrine

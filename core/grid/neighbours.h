#pragma once

#include <array>

#include "core/grid/voxel_grid.h"

namespace citrine {

namespace detail {
template <int kCount, int kMaxSteps>
constexpr std::array<std::array<int, 3>, kCount> Neighbours() {
  std::array<std::array<int, 3>, kCount> offsets{};
  int n = 0;
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const int steps = x * x + y * y + z * z;
        if (steps > 0 && steps <= kMaxSteps) offsets[n++] = {x, y, z};
      }
  return offsets;
}
}  // namespace detail

/// Offsets of the 6, 18 and 26 neighbours of a voxel, in order of z, y, x.
inline constexpr auto kN6 = detail::Neighbours<6, 1>();
inline constexpr auto kN18 = detail::Neighbours<18, 2>();
inline constexpr auto kN26 = detail::Neighbours<26, 3>();

}  // namespace citrine

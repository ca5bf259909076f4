#include "viz/palette.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace citrine::viz {

Colour UavColour(int uav) {
  static constexpr std::array<Colour, 7> kOkabeIto{{{230, 159, 0},
                                                    {86, 180, 233},
                                                    {204, 121, 167},
                                                    {240, 228, 66},
                                                    {213, 94, 0},
                                                    {0, 158, 115},
                                                    {0, 114, 178}}};
  return kOkabeIto[static_cast<std::size_t>(std::max(uav - 1, 0)) % kOkabeIto.size()];
}

Colour ShareColour(double share) {
  // From an eighth of the way up: what was barely seen is to differ from what was not seen.
  static constexpr std::array<Colour, 8> kMako{{{37, 25, 52},
                                                {62, 53, 107},
                                                {59, 86, 152},
                                                {53, 123, 162},
                                                {52, 155, 170},
                                                {73, 193, 173},
                                                {160, 223, 185},
                                                {222, 245, 229}}};
  const double at = std::clamp(share, 0.0, 1.0) * (kMako.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), kMako.size() - 2);
  return Mix(kMako[low], kMako[low + 1], at - static_cast<double>(low));
}

Colour Mix(Colour a, Colour b, double t) {
  const auto mix = [t](std::uint8_t x, std::uint8_t y) {
    return static_cast<std::uint8_t>(std::lround(x + t * (y - x)));
  };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

Colour Shaded(Colour colour, double factor) {
  const auto shade = [factor](std::uint8_t x) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(x * factor, 0.0, 255.0)));
  };
  return {shade(colour.r), shade(colour.g), shade(colour.b)};
}

}  // namespace citrine::viz

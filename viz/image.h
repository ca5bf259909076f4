#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace citrine::viz {

struct Colour {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Colour&) const = default;
};

/// Pixels row by row from the top left, three bytes each: blue, green, red.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bgr;

  Image() = default;
  Image(int width_px, int height_px, Colour colour);

  std::uint8_t* At(int x, int y) { return &bgr[3 * (static_cast<std::size_t>(y) * width + x)]; }
  const std::uint8_t* At(int x, int y) const { return &bgr[3 * (static_cast<std::size_t>(y) * width + x)]; }
  Colour ColourAt(int x, int y) const { return {At(x, y)[2], At(x, y)[1], At(x, y)[0]}; }
  void Set(int x, int y, Colour colour) {
    std::uint8_t* p = At(x, y);
    p[0] = colour.b, p[1] = colour.g, p[2] = colour.r;
  }
};

}  // namespace citrine::viz

#include "viz/image.h"

namespace citrine::viz {

Image::Image(int width_px, int height_px, Colour colour)
    : width(width_px), height(height_px), bgr(3 * static_cast<std::size_t>(width_px) * height_px) {
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) Set(x, y, colour);
}

}  // namespace citrine::viz

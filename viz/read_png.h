#pragma once

#include <cstdint>
#include <string>

#include "viz/image.h"

namespace citrine::viz {

/// @throws FrameError if the file is not there or no picture
Image ReadPng(const std::string& path);

/// Where two pictures are not the same.
struct PixelDifference {
  std::int64_t pixels = 0;
  int x = 0, y = 0;  ///< of the first, row by row
};

/// Pixels that only one of the pictures has differ. @throws FrameError
PixelDifference ComparePngs(const std::string& path_a, const std::string& path_b);

}  // namespace citrine::viz

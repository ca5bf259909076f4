#include "viz/read_png.h"

#include <algorithm>

#include <opencv2/imgcodecs.hpp>

#include "viz/frame_writer.h"

namespace citrine::viz {

Image ReadPng(const std::string& path) {
  const cv::Mat read = cv::imread(path, cv::IMREAD_COLOR);
  if (read.empty()) throw FrameError(path + ": no picture that can be read");
  Image image(read.cols, read.rows, Colour{});
  for (int y = 0; y < read.rows; ++y) std::copy_n(read.ptr(y), 3 * read.cols, image.At(0, y));
  return image;
}

PixelDifference ComparePngs(const std::string& path_a, const std::string& path_b) {
  const Image a = ReadPng(path_a), b = ReadPng(path_b);
  const auto has = [](const Image& image, int x, int y) { return x < image.width && y < image.height; };
  PixelDifference difference;
  for (int y = 0; y < std::max(a.height, b.height); ++y)
    for (int x = 0; x < std::max(a.width, b.width); ++x) {
      if (has(a, x, y) && has(b, x, y) && a.ColourAt(x, y) == b.ColourAt(x, y)) continue;
      if (difference.pixels++ > 0) continue;
      difference.x = x;
      difference.y = y;
    }
  return difference;
}

}  // namespace citrine::viz

#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "viz/image.h"

namespace citrine::viz {

/// A picture that could not be written or shown: one line with what and where.
struct FrameError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Writes a PNG in place of whatever `path` was, at once, so that a reader never sees half of it.
/// @throws FrameError
void WritePng(const std::string& path, const Image& image);

/// An MP4 file: H.264 where this machine's OpenCV can, else MPEG-4 part 2. Complete when destroyed.
class VideoWriter {
 public:
  /// @throws FrameError if no encoder opens
  VideoWriter(const std::string& path, int width, int height, double frames_per_s);
  ~VideoWriter();
  /// @throws FrameError for an image of another size
  void Add(const Image& image);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace citrine::viz

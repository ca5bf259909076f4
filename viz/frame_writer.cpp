#include "viz/frame_writer.h"

#include <cstdio>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

namespace citrine::viz {

namespace {

/// OpenCV's functions read only, but its matrices know no constness.
cv::Mat View(const Image& image) {
  return {image.height, image.width, CV_8UC3, const_cast<std::uint8_t*>(image.bgr.data())};
}

}  // namespace

void WritePng(const std::string& path, const Image& image) {
  const std::string unfinished = path + ".part.png";
  bool written = false;
  try {
    written = cv::imwrite(unfinished, View(image));
  } catch (const cv::Exception&) {
  }
  if (!written || std::rename(unfinished.c_str(), path.c_str()) != 0)
    throw FrameError(path + ": cannot be written");
}

struct VideoWriter::Impl {
  std::string path;
  cv::VideoWriter writer;
  cv::Size size;
};

VideoWriter::VideoWriter(const std::string& path, int width, int height, double frames_per_s)
    : impl_(std::make_unique<Impl>()) {
  impl_->path = path;
  impl_->size = {width, height};
  for (const char* code : {"avc1", "mp4v"}) {
    const int fourcc = cv::VideoWriter::fourcc(code[0], code[1], code[2], code[3]);
    try {
      if (impl_->writer.open(path, fourcc, frames_per_s, impl_->size)) return;
    } catch (const cv::Exception&) {
    }
  }
  throw FrameError(path + ": no video encoder opens (tried avc1 and mp4v)");
}

VideoWriter::~VideoWriter() = default;

void VideoWriter::Add(const Image& image) {
  if (cv::Size(image.width, image.height) != impl_->size)
    throw FrameError(impl_->path + ": a frame of another size");
  impl_->writer.write(View(image));
}

}  // namespace citrine::viz

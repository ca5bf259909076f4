#include "viz/frame_writer.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace citrine::viz {
namespace {

std::string Head(const std::string& path, std::size_t size) {
  std::ifstream file(path, std::ios::binary);
  std::string head(size, '\0');
  file.read(head.data(), static_cast<std::streamsize>(size));
  return head;
}

TEST(WritePng, WritesAPngAndLeavesNothingElseBehind) {
  const std::filesystem::path folder = testing::TempDir() + "citrine_frames";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  WritePng(folder / "frame.png", Image(64, 48, {10, 20, 30}));
  EXPECT_EQ(Head(folder / "frame.png", 4), "\x89PNG");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST(WritePng, SaysWhereItCouldNotWrite) {
  try {
    WritePng("/nonexistent/frame.png", Image(8, 8, {}));
    FAIL() << "wrote into a folder that is not there";
  } catch (const FrameError& error) {
    EXPECT_NE(std::string(error.what()).find("/nonexistent/frame.png"), std::string::npos);
  }
}

TEST(VideoWriter, WritesAnMp4) {
  const std::string path = testing::TempDir() + "citrine_frames.mp4";
  {
    VideoWriter video(path, 320, 240, 10);
    for (int k = 0; k < 20; ++k) video.Add(Image(320, 240, {static_cast<std::uint8_t>(10 * k), 40, 80}));
    EXPECT_THROW(video.Add(Image(8, 8, {})), FrameError);
  }
  EXPECT_EQ(Head(path, 8).substr(4), "ftyp");
  EXPECT_GT(std::filesystem::file_size(path), 1000u);
}

}  // namespace
}  // namespace citrine::viz

#include "viz/window.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include <gtest/gtest.h>

#include "tests/support/citrine_command.h"
#include "viz/display.h"
#include "viz/frame_writer.h"

namespace citrine::viz {
namespace {

namespace fs = std::filesystem;

/// A display without a screen, whose picture lies in a file (in the XWD format).
class VirtualDisplay {
 public:
  VirtualDisplay()
      : folder_(fs::path(::testing::TempDir()) / ("citrine_display_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    int pipe_ends[2];
    if (pipe(pipe_ends) != 0) return;
    server_ = fork();
    if (server_ == 0) {
      const std::string number_to = std::to_string(pipe_ends[1]);
      const int nowhere = open("/dev/null", O_WRONLY);
      dup2(nowhere, STDERR_FILENO);
      execlp("Xvfb", "Xvfb", "-displayfd", number_to.c_str(), "-screen", "0", "1024x768x24", "-noreset",
             "-nolisten", "tcp", "-fbdir", folder_.c_str(), static_cast<char*>(nullptr));
      _exit(127);
    }
    close(pipe_ends[1]);
    for (char c; read(pipe_ends[0], &c, 1) == 1 && c != '\n';) number_.push_back(c);
    close(pipe_ends[0]);
    if (works()) setenv("DISPLAY", (":" + number_).c_str(), 1);
  }
  ~VirtualDisplay() {
    unsetenv("DISPLAY");
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
    fs::remove_all(folder_);
  }
  bool works() const { return !number_.empty(); }

  Colour ColourAt(int x, int y) const {
    std::ifstream in(folder_ / "Xvfb_screen0", std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(in), {});
    const auto header = [&](std::size_t field) {
      std::size_t value = 0;
      for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | static_cast<std::uint8_t>(bytes.at(4 * field + i));
      return value;
    };
    const std::size_t pixels = header(0) + 12 * header(19);
    const std::size_t pixel = pixels + header(12) * y + header(11) / 8 * x;
    const auto channel = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes.at(pixel + i)); };
    return {channel(2), channel(1), channel(0)};
  }

 private:
  fs::path folder_;
  pid_t server_ = -1;
  std::string number_;
};

/// Asks again until it is so; the desktop takes its time.
template <class Condition>
bool Eventually(const Condition& condition) {
  for (int k = 0; k < 500; ++k) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return false;
}

TEST(Window, SaysThatThereIsNoDisplay) {
  const char* x = std::getenv("DISPLAY");
  const char* wayland = std::getenv("WAYLAND_DISPLAY");
  if (x != nullptr || wayland != nullptr) GTEST_SKIP() << "this machine has a display";
  EXPECT_THROW(Window("citrine"), FrameError);
}

TEST(Window, SaysThatADisplayDoesNotAnswer) {
  const char* set = std::getenv("DISPLAY");
  const std::string before = set ? set : "";
  setenv("DISPLAY", ":1234", 1);
  EXPECT_EQ(WhyNoDisplay(), "the display ':1234' does not answer");
  EXPECT_FALSE(ScreenSize_px());
  EXPECT_THROW(Window("citrine"), FrameError);
  if (set)
    setenv("DISPLAY", before.c_str(), 1);
  else
    unsetenv("DISPLAY");
}

TEST(Window, ShowsAPictureAndTellsWhatItsViewerDoes) {
  if (RunCommandLine("command -v xdotool Xvfb").exit_code != 0)
    GTEST_SKIP() << "Xvfb or xdotool is not there (packages-tools.txt)";
  const VirtualDisplay display;
  ASSERT_TRUE(display.works());
  EXPECT_EQ(WhyNoDisplay(), "");
  EXPECT_EQ(ScreenSize_px(), Eigen::Vector2d(1024, 768));
  const Colour red{200, 30, 40};
  Window window("citrine test");
  window.Show(Image(640, 480, red));
  std::vector<WindowEvent> events;
  const auto take = [&] {
    for (const WindowEvent& event : window.TakeEvents()) events.push_back(event);
  };
  EXPECT_TRUE(Eventually([&] {
    take();
    return display.ColourAt(320, 240) == red;
  }));

  events.clear();
  EXPECT_EQ(RunCommandLine("xdotool mousemove 100 100 click 1").exit_code, 0);
  for (const auto& [name, code] : {std::pair{"plus", int{'+'}}, std::pair{"a", int{'a'}}}) {
    EXPECT_EQ(RunCommandLine(std::string("xdotool key ") + name).exit_code, 0);
    const auto is_key = [&, key = code](const WindowEvent& event) {
      return event.kind == WindowEvent::Kind::kKey && event.key == key;
    };
    EXPECT_TRUE(Eventually([&] {
      take();
      return std::any_of(events.begin(), events.end(), is_key);
    })) << name;
  }

  events.clear();
  EXPECT_EQ(RunCommandLine("xdotool mousedown 1 mousemove 150 120 mouseup 1").exit_code, 0);
  Eigen::Vector2d moved_px = Eigen::Vector2d::Zero();
  EXPECT_TRUE(Eventually([&] {
    events.clear();
    take();
    for (const WindowEvent& event : events)
      if (event.kind == WindowEvent::Kind::kDrag) moved_px += event.moved_px;
    return (moved_px - Eigen::Vector2d(50, 20)).norm() < 2;  // the window may be a pixel off the picture
  })) << moved_px.transpose();
}

}  // namespace
}  // namespace citrine::viz

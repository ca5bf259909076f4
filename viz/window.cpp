#include "viz/window.h"

#include <utility>

#include <opencv2/highgui.hpp>

#include "viz/display.h"
#include "viz/frame_writer.h"

namespace citrine::viz {

Window::Window(std::string title) : title_(std::move(title)) {
  if (const std::string why = WhyNoDisplay(); !why.empty()) throw FrameError("no window: " + why);
  try {
    cv::namedWindow(title_, cv::WINDOW_NORMAL | cv::WINDOW_KEEPRATIO | cv::WINDOW_GUI_NORMAL);
    cv::setMouseCallback(title_, &Window::OnMouse, this);
  } catch (const cv::Exception& error) {
    throw FrameError("no window: " + error.err);
  }
}

Window::~Window() {
  try {
    cv::destroyWindow(title_);
  } catch (const cv::Exception&) {
  }
}

bool Window::IsClosed() const { return shown_ && cv::getWindowProperty(title_, cv::WND_PROP_VISIBLE) < 1; }

void Window::Show(const Image& image) {
  if (IsClosed()) return;
  const cv::Mat view(image.height, image.width, CV_8UC3, const_cast<std::uint8_t*>(image.bgr.data()));
  cv::imshow(title_, view);
  if (!shown_) cv::resizeWindow(title_, image.width, image.height);
  shown_ = true;
}

std::vector<WindowEvent> Window::TakeEvents() {
  if (!IsClosed())
    for (int key; (key = cv::waitKeyEx(1)) >= 0;) events_.push_back(WindowEvent::Key(key));
  return std::exchange(events_, {});
}

void Window::OnMouse(int event, int x, int y, int flags, void* window) {
  auto& self = *static_cast<Window*>(window);
  const Eigen::Vector2d at_px(x, y);
  if (event == cv::EVENT_LBUTTONDBLCLK) self.events_.push_back(WindowEvent::DoubleClick(at_px));
  if (event == cv::EVENT_MOUSEMOVE && (flags & cv::EVENT_FLAG_LBUTTON))
    self.events_.push_back(WindowEvent::Drag(at_px, at_px - self.dragged_from_px_));
  self.dragged_from_px_ = at_px;
}

}  // namespace citrine::viz

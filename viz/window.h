#pragma once

#include <string>
#include <vector>

#include "viz/image.h"
#include "viz/window_event.h"

namespace citrine::viz {

/// A window on the desktop, until its viewer closes it.
class Window {
 public:
  /// @throws FrameError where there is no display
  explicit Window(std::string title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Nothing happens once it has been closed.
  void Show(const Image& image);

  /// What its viewer has done since the last call; lets the desktop's events be handled meanwhile.
  std::vector<WindowEvent> TakeEvents();

 private:
  static void OnMouse(int event, int x, int y, int flags, void* window);
  bool IsClosed() const;

  std::string title_;
  bool shown_ = false;  ///< sized to the first image; from then on it is the viewer's to size
  Eigen::Vector2d dragged_from_px_ = Eigen::Vector2d::Zero();
  std::vector<WindowEvent> events_;
};

}  // namespace citrine::viz

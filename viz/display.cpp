#include "viz/display.h"

#include <cstdlib>
#include <memory>

#include <xcb/xcb.h>

namespace citrine::viz {
namespace {

using Connection = std::unique_ptr<xcb_connection_t, decltype(&xcb_disconnect)>;

/// Null where the display that DISPLAY names does not answer.
Connection Connect() {
  Connection connection(xcb_connect(nullptr, nullptr), &xcb_disconnect);
  if (xcb_connection_has_error(connection.get()) != 0) connection.reset();
  return connection;
}

}  // namespace

std::string WhyNoDisplay() {
  const char* display = std::getenv("DISPLAY");
  if (!display && std::getenv("WAYLAND_DISPLAY")) return {};
  if (!display) return "there is no display (neither DISPLAY nor WAYLAND_DISPLAY is set)";
  return Connect() ? "" : std::string("the display '") + display + "' does not answer";
}

std::optional<Eigen::Vector2d> ScreenSize_px() {
  const Connection connection = std::getenv("DISPLAY") ? Connect() : Connection(nullptr, &xcb_disconnect);
  if (!connection) return std::nullopt;
  const xcb_screen_t* screen = xcb_setup_roots_iterator(xcb_get_setup(connection.get())).data;
  return Eigen::Vector2d(screen->width_in_pixels, screen->height_in_pixels);
}

}  // namespace citrine::viz

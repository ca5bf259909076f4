#include "viz/display.h"

#include <cstdlib>
#include <memory>

#include <xcb/xcb.h>

namespace citrine::viz {

std::string WhyNoDisplay() {
  const char* display = std::getenv("DISPLAY");
  if (!display && std::getenv("WAYLAND_DISPLAY")) return {};
  if (!display) return "there is no display (neither DISPLAY nor WAYLAND_DISPLAY is set)";
  const std::unique_ptr<xcb_connection_t, decltype(&xcb_disconnect)> connection(xcb_connect(display, nullptr),
                                                                                &xcb_disconnect);
  if (xcb_connection_has_error(connection.get()) == 0) return {};
  return std::string("the display '") + display + "' does not answer";
}

}  // namespace citrine::viz

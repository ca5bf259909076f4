#pragma once

#include <string>

namespace citrine::viz {

/// Why no window can be shown here, in one line: no display is named, or the X server that DISPLAY names does
/// not answer. Empty where one can.
std::string WhyNoDisplay();

}  // namespace citrine::viz

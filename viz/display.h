#pragma once

#include <optional>
#include <string>

#include <Eigen/Core>

namespace citrine::viz {

/// Why no window can be shown here, in one line: no display is named, or the X server that DISPLAY names does
/// not answer. Empty where one can.
std::string WhyNoDisplay();

/// Columns and rows of the X server's screen; nothing where there is none, or it is not X.
std::optional<Eigen::Vector2d> ScreenSize_px();

}  // namespace citrine::viz

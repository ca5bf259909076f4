#include <string>

#include "viz/layers.h"
#include "viz/palette.h"
#include "viz/view_control.h"

namespace citrine::viz {

/// What the keys of a window do, over the map.
void DrawHelp(const View& view, Canvas& canvas) {
  const double s = canvas.scale(), line = 26 * s;
  const auto rows = static_cast<double>(ViewControl::Keys().size() + Layers().size());
  const Pixel corner(28 * s, 28 * s);
  canvas.Fill({corner, corner + Pixel(470 * s, (rows + 0.3) * line)}, kOutline, 0.85);
  Pixel at = corner + Pixel(20 * s, 0);
  const auto row = [&](const std::string& key, const std::string& text, Colour colour) {
    at.y() += line;
    canvas.Text(at, key, kText, 12 * s);
    canvas.Text(at + Pixel(96 * s, 0), text, colour, 12 * s);
  };
  for (const ViewControl::Key& key : ViewControl::Keys()) row(key.name, key.does, kText);
  for (const Layer& layer : Layers()) {
    if (layer.key == 0) continue;
    const bool hidden = view.hidden.find(layer.key) != std::string::npos;
    row({layer.key}, std::string(layer.name) + (hidden ? ": hidden" : ""), hidden ? kTextDim : kText);
  }
}

}  // namespace citrine::viz

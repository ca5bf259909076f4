#include "viz/layers.h"
#include "viz/layers/paint_relief.h"

namespace citrine::viz {

/// Colours the hills by the share of w* that their confidence has reached.
void DrawConfidence(const Scene&, const Relief& relief, Canvas& canvas) {
  constexpr float kCover = 0.85f;
  PaintRelief(relief, canvas, [&](std::size_t cell, float height) {
    if (relief.seen[cell] != Relief::Seen::kSurface) return Paint{};
    const double lift = 0.88 + 0.2 * height;
    return Paint{Shaded(ShareColour(relief.share[cell]), lift * relief.light[cell]), kCover};
  });
}

}  // namespace citrine::viz

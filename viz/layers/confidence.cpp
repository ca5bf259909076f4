#include "viz/layers.h"
#include "viz/palette.h"

namespace citrine::viz {

/// Colours the hills by the share of w* that their confidence has reached.
void DrawConfidence(const Scene&, const Relief& relief, Canvas& canvas) {
  if (relief.width == 0) return;
  constexpr float kCover = 0.85f;
  Image cells(relief.width, relief.height, kKnownFree);
  std::vector<float> cover(relief.seen.size(), 0);
  const float span_m = std::max(relief.highest_m - relief.lowest_m, 1.0f);
  for (int y = 0; y < relief.height; ++y) {
    for (int x = 0; x < relief.width; ++x) {
      const std::size_t cell = relief.Cell(x, y);
      if (relief.seen[cell] != Relief::Seen::kSurface) continue;
      const double lift = 0.88 + 0.2 * (relief.top_m[cell] - relief.lowest_m) / span_m;
      cells.Set(x, y, Shaded(ShareColour(relief.share[cell]), lift * relief.light[cell]));
      cover[cell] = kCover;
    }
  }
  canvas.Lay(cells, cover, relief.corner_W, relief.cell_m);
}

}  // namespace citrine::viz

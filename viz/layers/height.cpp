#include "viz/layers.h"
#include "viz/palette.h"

namespace citrine::viz {

/// Grey hills: lit from the north-west, lighter the higher.
void DrawHeight(const Scene&, const Relief& relief, Canvas& canvas) {
  if (relief.width == 0) return;
  constexpr Colour kLow{120, 124, 130}, kHigh{214, 216, 218};
  Image cells(relief.width, relief.height, kKnownFree);
  std::vector<float> cover(relief.seen.size(), 0);
  const float span_m = std::max(relief.highest_m - relief.lowest_m, 1.0f);
  for (int y = 0; y < relief.height; ++y) {
    for (int x = 0; x < relief.width; ++x) {
      const std::size_t cell = relief.Cell(x, y);
      if (relief.seen[cell] == Relief::Seen::kNothing) continue;
      cover[cell] = 1;
      if (relief.seen[cell] == Relief::Seen::kFree) continue;
      const Colour rock = Mix(kLow, kHigh, (relief.top_m[cell] - relief.lowest_m) / span_m);
      cells.Set(x, y, Shaded(rock, relief.light[cell]));
    }
  }
  canvas.Lay(cells, cover, relief.corner_W, relief.cell_m);
}

}  // namespace citrine::viz

#pragma once

#include "viz/canvas.h"
#include "viz/palette.h"
#include "viz/relief.h"

namespace citrine::viz {

/// How a cell of a relief is painted.
struct Paint {
  Colour colour = kKnownFree;
  float cover = 0;  ///< 0..1, how much of it hides what lies below
};

/// Lays `paint_of(cell, height)` over the map, cell by cell of the relief; `height` is the surface's among
/// all that are seen, 0..1 from the lowest, and counts where there is one.
template <class PaintOf>
void PaintRelief(const Relief& relief, Canvas& canvas, const PaintOf& paint_of) {
  if (relief.width == 0) return;
  Image cells(relief.width, relief.height, kKnownFree);
  std::vector<float> cover(relief.seen.size(), 0);
  const float span_m = std::max(relief.highest_m - relief.lowest_m, 1.0f);
  for (int y = 0; y < relief.height; ++y)
    for (int x = 0; x < relief.width; ++x) {
      const std::size_t cell = relief.Cell(x, y);
      const Paint paint = paint_of(cell, (relief.top_m[cell] - relief.lowest_m) / span_m);
      cells.Set(x, y, paint.colour);
      cover[cell] = paint.cover;
    }
  canvas.Lay(cells, cover, relief.corner_W, relief.cell_m);
}

}  // namespace citrine::viz

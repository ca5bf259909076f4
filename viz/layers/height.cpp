#include "viz/layers.h"
#include "viz/layers/paint_relief.h"

namespace citrine::viz {

/// Grey hills: lit from the north-west, lighter the higher.
void DrawHeight(const Scene&, const Relief& relief, Canvas& canvas) {
  constexpr Colour kLow{120, 124, 130}, kHigh{214, 216, 218};
  PaintRelief(relief, canvas, [&](std::size_t cell, float height) {
    switch (relief.seen[cell]) {
      case Relief::Seen::kNothing:
        return Paint{};
      case Relief::Seen::kFree:
        return Paint{kKnownFree, 1};
      case Relief::Seen::kSurface:
        break;
    }
    return Paint{Shaded(Mix(kLow, kHigh, height), relief.light[cell]), 1};
  });
}

}  // namespace citrine::viz

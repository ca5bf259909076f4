#include <algorithm>

#include "viz/layers.h"
#include "viz/palette.h"

namespace citrine::viz {

/// Views that were to choose from, worst first, by their score; the chosen one with the line of sight to its
/// element.
void DrawCandidates(const Scene& scene, const Relief&, Canvas& canvas) {
  const double s = canvas.scale();
  std::vector<const Scene::Candidate*> order;
  for (const Scene::Candidate& candidate : scene.candidates) order.push_back(&candidate);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto* a, const auto* b) { return a->share < b->share; });
  for (const Scene::Candidate* candidate : order) {
    const Pixel at = canvas.ToPixel(candidate->p_W);
    canvas.Disc(at, 4 * s, kOutline, 0.8);
    canvas.Disc(at, 3 * s, ShareColour(candidate->share));
  }
  for (const Scene::Candidate& candidate : scene.candidates) {
    if (!candidate.chosen) continue;
    const Pixel at = canvas.ToPixel(candidate.p_W), element = canvas.ToPixel(candidate.element_W);
    canvas.Polyline({at, element}, kOutline, 5 * s);
    canvas.Polyline({at, element}, kText, 2.5 * s);
    canvas.Ring(at, 9 * s, kText, 2.5 * s);
    canvas.Disc(element, 4 * s, kLowQuality);
  }
}

}  // namespace citrine::viz

#pragma once

#include <vector>

#include "viz/layer.h"
#include "viz/view.h"

namespace citrine::viz {

/// THE LIST: the layers of a picture from bottom to top. A new one is a file in layers/ and a row here.
const std::vector<Layer>& Layers();

void DrawHeight(const Scene& scene, const Relief& relief, Canvas& canvas);
void DrawConfidence(const Scene& scene, const Relief& relief, Canvas& canvas);
void DrawQualityRegions(const Scene& scene, const Relief& relief, Canvas& canvas);
void DrawActiveElements(const Scene& scene, const Relief& relief, Canvas& canvas);
void DrawTrails(const Scene& scene, const Relief& relief, Canvas& canvas);
void DrawPlans(const Scene& scene, const Relief& relief, Canvas& canvas);
void DrawCandidates(const Scene& scene, const Relief& relief, Canvas& canvas);
void DrawUavs(const Scene& scene, const Relief& relief, Canvas& canvas);
void DrawScaleBar(const Scene& scene, const Relief& relief, Canvas& canvas);
void DrawStrip(const Scene& scene, const Relief& relief, Canvas& canvas);

/// Not a layer: only in windows, and only when asked for.
void DrawHelp(const View& view, Canvas& canvas);

}  // namespace citrine::viz

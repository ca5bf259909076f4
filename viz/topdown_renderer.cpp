#include "viz/topdown_renderer.h"

#include <algorithm>

#include "viz/canvas.h"
#include "viz/layers.h"
#include "viz/relief.h"

namespace citrine::viz {

namespace {
constexpr double kMargin_m = 0.75;
}  // namespace

TopdownRenderer::TopdownRenderer(const Eigen::AlignedBox3d& volume_W, double pixels_per_m) {
  whole_.area_W = {volume_W.min().head<2>().array() - kMargin_m,
                   volume_W.max().head<2>().array() + kMargin_m};
  const Eigen::Array2d fitting = Canvas::kFullHdMap_px.array() / whole_.area_W.sizes().array();
  whole_.pixels_per_m = pixels_per_m > 0 ? pixels_per_m : fitting.minCoeff();
}

View TopdownRenderer::WholeWithin(const Eigen::Vector2d& room_px) const {
  const Image full = Canvas(whole_.area_W, whole_.pixels_per_m).image();
  View view = whole_;
  view.pixels_per_m *= std::min({1.0, room_px.x() / full.width, room_px.y() / full.height});
  return view;
}

Image TopdownRenderer::Draw(const Scene& scene, const View& view) const {
  Canvas canvas(view.area_W, view.pixels_per_m);
  const Relief relief = ReliefOf(scene);
  for (const Layer& layer : Layers())
    if (layer.key == 0 || view.hidden.find(layer.key) == std::string::npos) layer.draw(scene, relief, canvas);
  if (view.help) DrawHelp(view, canvas);
  return canvas.image();
}

}  // namespace citrine::viz

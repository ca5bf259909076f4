#include "viz/topdown_renderer.h"

#include "viz/canvas.h"
#include "viz/layers.h"
#include "viz/relief.h"

namespace citrine::viz {

namespace {
constexpr double kMargin_m = 0.75;
}

TopdownRenderer::TopdownRenderer(const Eigen::AlignedBox3d& volume_W, double pixels_per_m)
    : area_W_(volume_W.min().head<2>().array() - kMargin_m, volume_W.max().head<2>().array() + kMargin_m),
      pixels_per_m_(pixels_per_m) {}

Image TopdownRenderer::Draw(const Scene& scene) const {
  Canvas canvas(area_W_, pixels_per_m_);
  const Relief relief = ReliefOf(scene);
  for (const Layer& layer : Layers()) layer.draw(scene, relief, canvas);
  return canvas.image();
}

}  // namespace citrine::viz

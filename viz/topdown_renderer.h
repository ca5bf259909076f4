#pragma once

#include "viz/image.h"
#include "viz/scene.h"

namespace citrine::viz {

/// Draws scenes of one mission from above, all in one size: the mission volume at a scale, and the strip
/// beside it.
class TopdownRenderer {
 public:
  TopdownRenderer(const Eigen::AlignedBox3d& volume_W, double pixels_per_m);

  Image Draw(const Scene& scene) const;

 private:
  Eigen::AlignedBox2d area_W_;
  double pixels_per_m_;
};

}  // namespace citrine::viz

#pragma once

#include "viz/image.h"
#include "viz/scene.h"
#include "viz/view.h"

namespace citrine::viz {

/// Draws scenes of one mission from above, all in one size: the mission volume at a scale, and the strip
/// beside it.
class TopdownRenderer {
 public:
  /// @param pixels_per_m 0: as large as a picture of 1920 by 1080 allows
  TopdownRenderer(const Eigen::AlignedBox3d& volume_W, double pixels_per_m);

  /// All of the mission, every layer.
  const View& whole() const { return whole_; }
  /// The same in a picture of no more columns and rows than these, where that is still legible.
  View WholeWithin(const Eigen::Vector2d& room_px) const;
  Image Draw(const Scene& scene) const { return Draw(scene, whole_); }
  /// @param view of as many pixels as the whole, or fewer
  Image Draw(const Scene& scene, const View& view) const;

 private:
  View whole_;
};

}  // namespace citrine::viz

#pragma once

#include <vector>

#include "core/grid/voxel_grid.h"
#include "viz/scene.h"

namespace citrine::viz {

/// What is seen of a map from above: one cell a column of voxels, row by row from the north, as a picture has
/// it.
struct Relief {
  enum class Seen : std::uint8_t { kNothing, kFree, kSurface };

  int width = 0, height = 0;
  double cell_m = 0;
  Eigen::Vector2d corner_W = Eigen::Vector2d::Zero();  ///< [m] south-west corner
  std::vector<Seen> seen;
  std::vector<float> top_m;  ///< highest observed surface below the ceiling
  std::vector<float> share;  ///< its confidence as a share of its w*, at most 1
  std::vector<float> light;  ///< 0..1 hill shading and cast shadow, lit from the north-west
  float lowest_m = 0, highest_m = 0;

  std::size_t Cell(int x, int y) const { return static_cast<std::size_t>(y) * width + x; }
};

/// Only columns inside the mission volume; without a map an empty relief.
Relief ReliefOf(const Scene& scene);

}  // namespace citrine::viz

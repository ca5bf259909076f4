#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/lidar/ray_scene.h"
#include "sim/world/world.h"

namespace citrine::sim {

/// A point of the true surface that stands for a small piece of it.
struct SurfaceSample {
  Eigen::Vector3f p_W;
  Eigen::Vector3f n_W;  ///< unit, into free space
  float area_m2 = 0;    ///< of the piece
  bool ground = false;
};

/// What there is to reconstruct (design, section 5): the world's surface clipped to the mission volume,
/// without faces that have solid 2 cm off on both sides.
struct TrueSurface {
  std::vector<SurfaceSample> samples;  ///< uniform over the area, in order of the world's triangles
  double area_m2 = 0;                  ///< of all samples
  double dropped_share = 0;            ///< [0, 1] of the clipped area that had solid on both sides
};

/// Samples the true surface with `density_per_m2` points a square metre; the same seed gives the same points.
TrueSurface SampleTrueSurface(const World& world, const RayScene& scene, const Eigen::AlignedBox3d& volume_W,
                              double density_per_m2, std::uint64_t seed);

}  // namespace citrine::sim

#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/lidar/ray_scene.h"

namespace citrine::sim {

inline constexpr double kLatticeStep_m = 0.5;

/// The poses that a UAV could take: points of a lattice over the mission volume (design, section 5).
struct ReachableLattice {
  Eigen::Vector3d origin_W = Eigen::Vector3d::Zero();  ///< [m] lattice point (0, 0, 0)
  Eigen::Vector3i size = Eigen::Vector3i::Zero();      ///< lattice points along each axis
  std::vector<std::uint8_t> reachable;                 ///< one a lattice point, x fastest

  bool Contains(const Eigen::Vector3i& i) const {
    return (i.array() >= 0).all() && (i.array() < size.array()).all();
  }
  std::size_t Linear(const Eigen::Vector3i& i) const {
    return static_cast<std::size_t>(i.x()) +
           static_cast<std::size_t>(size.x()) * (i.y() + static_cast<std::size_t>(size.y()) * i.z());
  }
  Eigen::Vector3i FromLinear(std::size_t linear) const {
    const auto nx = static_cast<std::size_t>(size.x()), ny = static_cast<std::size_t>(size.y());
    return {static_cast<int>(linear % nx), static_cast<int>(linear / nx % ny),
            static_cast<int>(linear / (nx * ny))};
  }
  Eigen::Vector3d Position(const Eigen::Vector3i& i) const {
    return origin_W + kLatticeStep_m * i.cast<double>();
  }
  Eigen::Vector3i Nearest(const Eigen::Vector3d& p_W) const {
    return ((p_W - origin_W) / kLatticeStep_m).array().round().cast<int>();
  }
  std::size_t num_reachable() const;
};

/// Lattice points inside the volume with clearance of at least `radius_m` that are joined to a spawn by such
/// neighbours along the axes. None if no spawn has such a point within a step.
ReachableLattice FindReachable(const RayScene& scene, const Eigen::AlignedBox3d& volume_W,
                               const std::vector<Eigen::Vector3d>& spawns_W, double radius_m);

}  // namespace citrine::sim

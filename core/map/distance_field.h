#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/grid/voxel_grid.h"

namespace citrine {

/// Exact Euclidean distance from every voxel centre to the nearest site centre, truncated at a radius, less
/// what a cautious reader takes off.
///
/// Kept as squared distance in voxels (u16); equal to brute force, full or incremental. Separable lower
/// envelope after Felzenszwalb & Huttenlocher (2012), here as windowed minima over 16 or 32 lanes.
class DistanceField {
 public:
  DistanceField() = default;
  /// @param radius_vox distances at or beyond it read as it
  /// @param caution_m  taken off every distance that is read: at sites it reads -caution_m
  DistanceField(const VoxelGrid& grid, int radius_vox, double caution_m = 0);

  /// Recomputes whatever a change of sites inside [min, max) can have changed.
  /// @param is_site one byte a voxel over the whole grid, nonzero at sites
  void Update(const std::vector<std::uint8_t>& is_site, const VoxelIndex& min, const VoxelIndex& max);

  /// [m] distance at a voxel, less the caution.
  float At(std::size_t linear) const { return metres_[squared_[linear]]; }
  /// As computed, without caution.
  std::uint16_t squared_vox(std::size_t linear) const { return squared_[linear]; }
  /// As above of all voxels, by linear index.
  const std::uint16_t* squared_vox() const { return squared_.data(); }

  /// Whether the distance at a point, interpolated, is certainly beyond one. False says nothing. The corners
  /// that interpolation takes lie on average sqrt(3/2) voxels from the nearest one at most.
  bool CertainlyBeyond(const Eigen::Vector3d& p_W, double distance_m) const {
    const VoxelIndex v = grid_.IndexOf(p_W);
    return (v.array() >= 0).all() && (v.array() < grid_.voxels().array()).all() &&
           At(grid_.Linear(v)) >= distance_m + 1.2247449 * grid_.voxel_m();
  }

  /// [m] distance at a point, trilinear between voxel centres; outside the grid that of the nearest voxel.
  double Interpolate(const Eigen::Vector3d& p_W) const { return Interpolate(p_W, nullptr); }
  /// As above, and its gradient: that of the interpolant, 0 along an axis on which the point is outside.
  double Interpolate(const Eigen::Vector3d& p_W, Eigen::Vector3d* gradient) const;

  int radius_vox() const { return radius_vox_; }
  double radius_m() const { return radius_vox_ * grid_.voxel_m() - caution_m_; }
  double caution_m() const { return caution_m_; }
  const VoxelGrid& grid() const { return grid_; }
  std::size_t bytes() const {
    return squared_.size() * sizeof squared_.front() + metres_.size() * sizeof metres_.front();
  }

 private:
  VoxelGrid grid_;
  int radius_vox_ = 0;
  double caution_m_ = 0;
  std::vector<std::uint16_t> squared_;
  std::vector<float> metres_;  ///< read, by squared distance
};

}  // namespace citrine

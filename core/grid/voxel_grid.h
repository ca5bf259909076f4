#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace citrine {

using VoxelIndex = Eigen::Vector3i;

inline constexpr int kBlockSide = 8;  ///< [voxels] edge of a block
inline constexpr int kBlockVoxels = kBlockSide * kBlockSide * kBlockSide;

/// A dense, bounded grid of cubic voxels, cut into blocks of 8x8x8, and the mission volume inside it.
///
/// Voxels are numbered x fastest over the whole grid (`Linear`); blocks likewise (`Block`), and the voxels
/// within a block (`InBlock`). Definitions of the paper are evaluated inside the mission volume only; the
/// margin around it belongs to the map, but counts as neither unknown nor occupied.
class VoxelGrid {
 public:
  VoxelGrid() = default;

  /// @param volume_W  [m] mission volume
  /// @param margin_m  how far the grid extends beyond the volume on every side, at least
  VoxelGrid(double voxel_m, const Eigen::AlignedBox3d& volume_W, double margin_m);

  double voxel_m() const { return voxel_m_; }
  const Eigen::Vector3d& origin_W() const { return origin_W_; }  ///< [m] lowest corner of voxel 0
  const Eigen::AlignedBox3d& volume_W() const { return volume_W_; }
  const Eigen::Vector3i& blocks() const { return blocks_; }
  const Eigen::Vector3i& voxels() const { return voxels_; }
  std::size_t num_voxels() const { return static_cast<std::size_t>(voxels_.x()) * voxels_.y() * voxels_.z(); }
  int num_blocks() const { return blocks_.x() * blocks_.y() * blocks_.z(); }
  std::size_t stride_y() const { return static_cast<std::size_t>(voxels_.x()); }
  std::size_t stride_z() const { return static_cast<std::size_t>(voxels_.x()) * voxels_.y(); }

  /// First and one-past-last voxel whose centre lies in the mission volume.
  const VoxelIndex& inside_min() const { return inside_min_; }
  const VoxelIndex& inside_max() const { return inside_max_; }

  VoxelIndex IndexOf(const Eigen::Vector3d& p_W) const {
    return ((p_W - origin_W_) * inv_voxel_m_).array().floor().cast<int>();
  }
  Eigen::Vector3d Centre(const VoxelIndex& v) const {
    return origin_W_ + (v.cast<double>().array() + 0.5).matrix() * voxel_m_;
  }
  bool Contains(const VoxelIndex& v) const {
    return (v.array() >= 0).all() && (v.array() < voxels_.array()).all();
  }
  bool Inside(const VoxelIndex& v) const {
    return (v.array() >= inside_min_.array()).all() && (v.array() < inside_max_.array()).all();
  }

  std::size_t Linear(const VoxelIndex& v) const {
    return static_cast<std::size_t>(v.x()) + stride_y() * v.y() + stride_z() * v.z();
  }
  VoxelIndex FromLinear(std::size_t i) const {
    const auto nx = static_cast<std::size_t>(voxels_.x());
    const auto ny = static_cast<std::size_t>(voxels_.y());
    return {static_cast<int>(i % nx), static_cast<int>(i / nx % ny), static_cast<int>(i / (nx * ny))};
  }

  int Block(const VoxelIndex& v) const {
    return v.x() / kBlockSide + blocks_.x() * (v.y() / kBlockSide + blocks_.y() * (v.z() / kBlockSide));
  }
  static int InBlock(const VoxelIndex& v) {
    return (v.x() % kBlockSide) + kBlockSide * ((v.y() % kBlockSide) + kBlockSide * (v.z() % kBlockSide));
  }
  /// Lowest voxel of a block.
  VoxelIndex BlockOrigin(int block) const {
    return kBlockSide * VoxelIndex(block % blocks_.x(), block / blocks_.x() % blocks_.y(),
                                   block / (blocks_.x() * blocks_.y()));
  }

  bool operator==(const VoxelGrid& other) const {
    return voxel_m_ == other.voxel_m_ && origin_W_ == other.origin_W_ && blocks_ == other.blocks_ &&
           inside_min_ == other.inside_min_ && inside_max_ == other.inside_max_;
  }

 private:
  double voxel_m_ = 0.25;
  double inv_voxel_m_ = 4.0;
  Eigen::AlignedBox3d volume_W_;
  Eigen::Vector3d origin_W_ = Eigen::Vector3d::Zero();
  Eigen::Vector3i blocks_ = Eigen::Vector3i::Zero();
  Eigen::Vector3i voxels_ = Eigen::Vector3i::Zero();
  VoxelIndex inside_min_ = VoxelIndex::Zero();
  VoxelIndex inside_max_ = VoxelIndex::Zero();
};

}  // namespace citrine

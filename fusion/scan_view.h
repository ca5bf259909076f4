#pragma once

#include <array>

#include <Eigen/Core>

#include "core/map/tsdf_map.h"
#include "core/sensor/lidar_scan.h"
#include "fusion/brick_sight.h"
#include "fusion/lanes.h"
#include "fusion/range_bounds.h"
#include "fusion/range_image.h"
#include "fusion/voxel_observer.h"

namespace citrine::fusion {

/// Eight points of the sensor frame [m].
struct Points {
  Lanes x, y, z;
};
/// Eight cubes of voxels, that make one of twice their side, and what a scan can say about them.
struct EightCubes {
  alignas(32) float x[8], y[8], z[8];  ///< [m] centres of their lowest voxels, sensor frame
  BrickSight sight;
  Eigen::Vector3f Lowest(int number) const { return {x[number], y[number], z[number]}; }
};

/// One scan, ready to be asked about cubes of voxels of a map.
class ScanView {
 public:
  /// @param scan,image,bounds  must outlive the view
  ScanView(const LidarScan& scan, const TsdfMap& map, const RangeImage& image, const RangeBounds& bounds)
      : model_(scan.model),
        observer_(image, map.grid().voxel_m(), map.truncation_m()),
        bounds_(bounds),
        voxel_m_(static_cast<float>(map.grid().voxel_m())),
        truncation_m_(static_cast<float>(map.truncation_m())),
        R_SW_(scan.X_WS.q.conjugate().toRotationMatrix()),
        p_WS_(scan.X_WS.p) {
    const Lanes x = _mm256_setr_ps(0, 1, 0, 1, 0, 1, 0, 1), y = _mm256_setr_ps(0, 0, 1, 1, 0, 0, 1, 1),
                z = _mm256_setr_ps(0, 0, 0, 0, 1, 1, 1, 1);
    for (int level = 0; level < kLevels; ++level) {
      const Eigen::Matrix3f step = (R_SW_ * ((1 << level) * map.grid().voxel_m())).cast<float>();
      const auto along = [&](int axis) {
        return MulAdd(x, step(axis, 0), MulAdd(y, step(axis, 1), z * step(axis, 2)));
      };
      corners_S_[level] = {along(0), along(1), along(2)};
      const double half_m = 0.5 * ((1 << level) - 1) * map.grid().voxel_m();
      diagonal_S_[level] = (R_SW_ * Eigen::Vector3d::Constant(half_m)).cast<float>();
    }
  }

  const LidarModel& model() const { return model_; }
  const VoxelObserver& observer() const { return observer_; }
  const Eigen::Vector3d& p_WS() const { return p_WS_; }

  /// Of the world in the sensor frame.
  Eigen::Vector3f InSensor(const Eigen::Vector3d& p_W) const { return (R_SW_ * (p_W - p_WS_)).cast<float>(); }
  /// Centres of the eight voxels of a brick, from the lowest on: bit 0 of their number is x, bit 1 y, bit 2
  /// z.
  Points VoxelsFrom(const Eigen::Vector3f& lowest_S) const { return From(lowest_S, 0); }
  /// The eight cubes, of 2^level voxels a side, of one whose lowest voxel has its centre there.
  EightCubes CubesFrom(const Eigen::Vector3f& lowest_S, int level) const {
    // From the centre of a cube to those of its outermost voxels, along an axis.
    const float half = 0.5f * static_cast<float>((1 << level) - 1);
    const float radius_m = half * 1.7322f * voxel_m_;  // a hair more than the root of 3
    const Points lowest = From(lowest_S, level);
    EightCubes cubes;
    Store(cubes.x, lowest.x);
    Store(cubes.y, lowest.y);
    Store(cubes.z, lowest.z);
    const Eigen::Vector3f& along_S = diagonal_S_[level];
    cubes.sight = SightOf(lowest.x + along_S.x(), lowest.y + along_S.y(), lowest.z + along_S.z(), radius_m,
                          model_, observer_, bounds_, truncation_m_);
    return cubes;
  }

 private:
  static constexpr int kLevels = 4;  // voxels, bricks, octants, blocks

  Points From(const Eigen::Vector3f& lowest_S, int level) const {
    const Points& corners = corners_S_[level];
    return {corners.x + lowest_S.x(), corners.y + lowest_S.y(), corners.z + lowest_S.z()};
  }

  const LidarModel& model_;
  VoxelObserver observer_;
  const RangeBounds& bounds_;
  float voxel_m_, truncation_m_;
  Eigen::Matrix3d R_SW_;
  Eigen::Vector3d p_WS_;
  std::array<Points, kLevels> corners_S_;            ///< of eight cubes of 2^level voxels, from the lowest on
  std::array<Eigen::Vector3f, kLevels> diagonal_S_;  ///< from the centre of a cube's lowest voxel to its own
};

}  // namespace citrine::fusion

#pragma once

#include <memory>
#include <vector>

#include "core/sensor/lidar_scan.h"
#include "sim/lidar/ray_scene.h"
#include "sim/world/world.h"

namespace citrine::test {

/// [m] mission volume of missions/house.toml
inline const Eigen::AlignedBox3d kHouseVolume_W{Eigen::Vector3d(-22.5, -20, 0),
                                                Eigen::Vector3d(22.5, 20, 20)};

/// The world of the House mission and a tour of it: around the house, past the playground, over the roof, at
/// 4 m/s and 10 scans a second, rolling by 6 and pitching by 5 degrees.
class HouseFlight {
 public:
  static constexpr int kPoses = 290;

  HouseFlight();

  const sim::World& world() const { return world_; }
  std::shared_ptr<const sim::RayScene> scene() const { return scene_; }

  /// Sensor poses along the tour, 0.4 m apart.
  const std::vector<Pose>& poses() const { return X_WS_; }

  /// What the emulator measures there, with range noise of sigma(r) = noise r^2. @param every  takes each
  /// such pose only
  std::vector<LidarScan> Scans(int rows, int cols, double noise_m_per_m2 = 1.5e-4, int every = 1) const;

 private:
  sim::World world_;
  std::shared_ptr<const sim::RayScene> scene_;
  std::vector<Pose> X_WS_;
};

}  // namespace citrine::test

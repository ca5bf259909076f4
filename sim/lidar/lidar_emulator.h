#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/random.h"
#include "core/sensor/lidar_scan.h"
#include "sim/lidar/ray_scene.h"

namespace citrine::sim {

/// Fires the LiDAR model's beams into the true world (paper, section V-A). Range noise has sigma(r) = noise
/// r^2. Other UAVs are seen as spheres of kAirframeRadius_m. A surface nearer than range_min makes a beam
/// kInvalid.
class LidarEmulator {
 public:
  LidarEmulator(std::shared_ptr<const RayScene> scene, const LidarModel& model, double noise_m_per_m2);

  /// One revolution, taken at one instant. @param teammates_W  centres of the other UAVs
  LidarScan Scan(Utime utime, const Pose& X_WS, const std::vector<Eigen::Vector3d>& teammates_W,
                 Random& random) const;

 private:
  /// Makes true ranges what the sensor says; infinity: nothing was met.
  void AddNoise(std::vector<float>& ranges_m, Random& random) const;

  std::shared_ptr<const RayScene> scene_;
  LidarModel model_;
  double noise_m_per_m2_;
  std::vector<Eigen::Vector3f> directions_S_;
};

}  // namespace citrine::sim

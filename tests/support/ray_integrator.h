#pragma once

#include "core/map/tsdf_map.h"
#include "core/sensor/lidar_scan.h"

namespace citrine::test {

/// The exact, slow way: every beam is walked through the voxels that it passes, and each takes the distance
/// along the beam, averaged by 1/r^2 (as Voxblox' `simple`). The oracle of the projective integrator.
class RayIntegrator {
 public:
  explicit RayIntegrator(TsdfMap& map) : map_(map) {}
  void Integrate(const LidarScan& scan);

 private:
  TsdfMap& map_;
};

}  // namespace citrine::test

#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/pose.h"
#include "core/time.h"

namespace citrine {

/// Where the beams of a sensor without a fixed pattern ended, measured at one instant. Beams that are missing
/// carve nothing.
struct PointCloud {
  Utime measured = 0;  ///< [us] mission time of the pose and of every point
  Pose X_WS;           ///< sensor in the world
  double range_min_m = 0;
  double range_max_m = 0;
  std::vector<Eigen::Vector3f> points_S;  ///< [m]
};

}  // namespace citrine

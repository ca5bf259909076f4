#pragma once

#include <vector>

#include "core/geometry/pose.h"
#include "core/sensor/lidar_model.h"
#include "core/time.h"

namespace citrine {

inline constexpr float kNoReturn = 0.0f;  ///< the beam met nothing within range: it carves free space
inline constexpr float kInvalid = -1.0f;  ///< the beam says nothing: it carves nothing

/// One revolution of a LiDAR, taken at one instant.
struct LidarScan {
  Utime measured = 0;  ///< [us] mission time of the pose and of every beam
  Pose X_WS;           ///< sensor in the world
  LidarModel model;
  std::vector<float> ranges_m;  ///< model.rows x model.cols, row by row; a range, kNoReturn or kInvalid
};

}  // namespace citrine

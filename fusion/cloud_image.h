#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/sensor/lidar_scan.h"
#include "core/sensor/point_cloud.h"

namespace citrine::fusion {

/// A cloud as a range image: each beam of the model has the nearest point in its pixel, and beams without a
/// point are invalid, so that they carve nothing. Points above, below or out of the model's range are left
/// out.
LidarScan Binned(const PointCloud& cloud, const LidarModel& model);

/// The beams that a sensor seems to have, from one sweep of it: its rings where elevations lie in rings
/// evenly apart, else pixels of a size that one point is to be expected in each. @return rows = 0 if no point
/// is within range
LidarModel GuessModel(const std::vector<Eigen::Vector3f>& points_S, double range_min_m, double range_max_m);

}  // namespace citrine::fusion

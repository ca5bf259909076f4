#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/sensor/lidar_scan.h"

namespace citrine::fusion {

inline constexpr double kAirframe_m = 0.35;        ///< radius of a UAV's body
inline constexpr double kTeammateMargin_m = 0.25;  ///< position error, motion and grazing hits around it

/// Makes returns on other UAVs invalid: they are no part of the world. (The beam before them is not carved
/// either.)
/// @param teammates_W  positions of the other UAVs when the scan was taken
/// @return how many returns were dropped
int DropTeammates(LidarScan& scan, const std::vector<Eigen::Vector3d>& teammates_W);

}  // namespace citrine::fusion

#pragma once

#include <citrine_lcm/lidar_scan_t.hpp>

#include "core/sensor/lidar_scan.h"

namespace citrine {

/// Ranges are rounded to a millimetre (to range_max_m / 32000 beyond 32 m).
/// @throws std::invalid_argument if the ranges are not one a beam, or one does not fit the model's range
citrine_lcm::lidar_scan_t Encode(const LidarScan& scan);

/// @throws BadMessage for a pose or model that is none, or ranges that do not fit it
LidarScan Decode(const citrine_lcm::lidar_scan_t& message);

}  // namespace citrine

#pragma once

#include <vector>

#include <citrine_lcm/point_cloud_t.hpp>

#include "core/sensor/point_cloud.h"

namespace citrine {

/// Cuts a sweep into messages of at most 33 kB; each can be integrated by itself.
std::vector<citrine_lcm::point_cloud_t> EncodeInMessages(const PointCloud& cloud);

/// One chunk: a part of the sweep. @throws BadMessage for a pose or limits that are none, or points that are
/// not finite
PointCloud Decode(const citrine_lcm::point_cloud_t& message);

}  // namespace citrine

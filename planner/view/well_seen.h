#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/map/planning_map.h"
#include "planner/view/elements.h"
#include "planner/view/sensor_window.h"

namespace citrine::planner {

/// Whether a look from a position should settle an element: within d*, a degree inside the field of view,
/// nothing occupied or unknown in between, and at most 72 degrees off the normal (beams that graze a surface
/// miss voxels of it).
bool WellSeen(const PlanningMap& map, const Element& element, const SensorWindow& window,
              const Eigen::Vector3d& p_W);

/// The voxels of all elements of which that is true, ascending.
std::vector<std::uint32_t> WellSeenFrom(const PlanningMap& map, const std::vector<Element>& elements,
                                        const SensorWindow& window, const Eigen::Vector3d& p_W);

}  // namespace citrine::planner

#pragma once

#include <functional>
#include <vector>

#include "core/map/planning_map.h"
#include "planner/view/elements.h"
#include "planner/view/patches.h"
#include "planner/view/sensor_window.h"
#include "planner/view/view.h"

namespace citrine::planner {

using OwnViews = std::function<std::vector<View>(const std::vector<std::size_t>& elements)>;

/// Views that settle most elements for the way to them (a choice of this project).
///
/// The paper's views lie along the normals, one for each element, all at one distance: seen from them the
/// ground is a thin ring, and from one of a few scattered elements to the next it is as far as d*. Here every
/// pose of a lattice from which a look should settle an element of a patch (WellSeen) is rated by the number
/// of all elements that it should settle, divided by the way to it; those that are nearly as good as the best
/// are returned, best first. An element of the patch that no pose should settle, or that a look already
/// failed to, is looked at from its own view.
/// @param own_views  makes those, for elements by their indices  @param allowed whether a UAV may fly to a
/// position  @param p_W where it is [m]
std::vector<View> RatedViews(const PlanningMap& map, const SensorWindow& window,
                             const std::vector<Element>& elements, const Patch& patch,
                             const OwnViews& own_views,
                             const std::function<bool(const Eigen::Vector3d&)>& allowed,
                             const Eigen::Vector3d& p_W);

}  // namespace citrine::planner

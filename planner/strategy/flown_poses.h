#pragma once

#include <vector>

#include "core/geometry/pose.h"
#include "core/map/planning_map.h"
#include "core/time.h"
#include "planner/view/elements.h"
#include "planner/view/sensor_window.h"

namespace citrine::planner {

/// Where the fleet has been, half a metre apart.
class FlownPoses {
 public:
  explicit FlownPoses(int uavs) : last_W_(static_cast<std::size_t>(uavs), Eigen::Vector3d::Constant(1e9)) {}

  void Add(int uav, const Pose& X_WB, Utime now);
  /// How many of the poses before a time should have settled an element (WellSeen), tilted as the UAV was;
  /// counted up to `enough`.
  int Looks(const PlanningMap& map, const Element& element, const SensorWindow& window, Utime before,
            int enough) const;

 private:
  struct Flown {
    Pose X_WB;
    Utime at;
  };
  std::vector<Eigen::Vector3d> last_W_;
  std::vector<Flown> flown_;
};

}  // namespace citrine::planner

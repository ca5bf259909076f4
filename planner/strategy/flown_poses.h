#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

#include "core/geometry/pose.h"
#include "core/map/planning_map.h"
#include "core/time.h"
#include "planner/view/elements.h"
#include "planner/view/sensor_window.h"

namespace citrine::planner {

/// Where the fleet has been, half a metre apart.
class FlownPoses {
 public:
  explicit FlownPoses(int uavs);

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
  /// Some poses of one UAV, one after the other.
  struct Stretch {
    Eigen::AlignedBox3d around_W;
    std::vector<Flown> flown;
  };
  std::vector<Eigen::Vector3d> last_W_;
  std::vector<std::size_t> newest_;  ///< by UAV: its stretch that grows
  std::vector<Stretch> stretches_;
};

}  // namespace citrine::planner

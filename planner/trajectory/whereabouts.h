#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "core/trajectory/trajectory.h"

namespace citrine::planner {

/// Boxes around where a motion is, half a second each: rules most of its neighbours out without evaluating
/// it.
class Whereabouts {
 public:
  /// @param from what lies before it is left out
  Whereabouts(const Trajectory& trajectory, Utime from);

  /// Whether the motion may be nearer than `distance_m` to a point, `t_s` seconds after `from`. Never false
  /// if it is.
  bool MayBeNear(const Eigen::Vector3d& p_W, double t_s, double distance_m) const;

 private:
  std::vector<Eigen::AlignedBox3d> boxes_W_;  ///< the last one holds for ever
};

}  // namespace citrine::planner

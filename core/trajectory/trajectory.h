#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/time.h"

namespace citrine {

/// State asked of a UAV at one instant.
struct TrajectoryPoint {
  Eigen::Vector3d p_W = Eigen::Vector3d::Zero();  ///< [m]
  Eigen::Vector3d v_W = Eigen::Vector3d::Zero();  ///< [m/s]
  Eigen::Vector3d a_W = Eigen::Vector3d::Zero();  ///< [m/s^2]
  Eigen::Vector3d j_W = Eigen::Vector3d::Zero();  ///< [m/s^3]
  double yaw_rad = 0;
  double yaw_rate_radps = 0;
};

/// One quintic piece: x(s) = sum_k coefficients(axis, k) s^k with s seconds since the piece began; axes x, y,
/// z, yaw.
struct TrajectorySegment {
  double duration_s = 0;
  Eigen::Matrix<double, 4, 6> coefficients = Eigen::Matrix<double, 4, 6>::Zero();
};

/// Piecewise quintic motion in mission time. Ends at rest; before its start and after its end it stands
/// still.
struct Trajectory {
  std::int64_t id = 0;       ///< counts up per UAV
  std::int64_t path_id = 0;  ///< the path that it follows
  Utime start = 0;
  std::vector<TrajectorySegment> segments;

  double duration_s() const;
  Utime end() const { return start + FromSeconds(duration_s()); }

  /// @throws std::logic_error if there is no segment
  TrajectoryPoint At(Utime time) const;
};

/// Whether `a` is newer than `b` of the same UAV: by id, or, of a smoother that was started again and counts
/// anew, by start. One that is repeated or late is not.
inline bool Supersedes(const Trajectory& a, const Trajectory& b) {
  return a.id > b.id || (a.id < b.id && a.start > b.start);
}

/// A trajectory that stands still at one point.
Trajectory Hover(const Eigen::Vector3d& p_W, double yaw_rad, Utime start);

}  // namespace citrine

#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "core/sensor/lidar_model.h"

namespace citrine::planner {

/// What a level LiDAR sees from where it stands: a full turn, a window of elevation, a window of range.
class SensorWindow {
 public:
  explicit SensorWindow(const LidarModel& model)
      : tan_min_(std::tan(model.elevation_min_rad)),
        tan_max_(std::tan(model.elevation_max_rad)),
        elevation_min_rad_(model.elevation_min_rad),
        elevation_max_rad_(model.elevation_max_rad),
        range_min_m_(model.range_min_m),
        range_max_m_(model.range_max_m) {}

  /// Whether a point at `to` relative to the sensor lies in the level field of view. [m]
  bool InFieldOfView(const Eigen::Vector3d& to) const {
    const double rho = std::sqrt(to.x() * to.x() + to.y() * to.y());
    return to.z() >= tan_min_ * rho && to.z() <= tan_max_ * rho;
  }
  bool InRange(double range_m) const { return range_m >= range_min_m_ && range_m <= range_max_m_; }
  bool Sees(const Eigen::Vector3d& to) const { return InRange(to.norm()) && InFieldOfView(to); }

  double elevation_min_rad() const { return elevation_min_rad_; }
  double elevation_max_rad() const { return elevation_max_rad_; }
  double range_min_m() const { return range_min_m_; }
  double range_max_m() const { return range_max_m_; }
  double tan_min() const { return tan_min_; }
  double tan_max() const { return tan_max_; }

 private:
  double tan_min_, tan_max_;
  double elevation_min_rad_, elevation_max_rad_;
  double range_min_m_, range_max_m_;
};

}  // namespace citrine::planner

#pragma once

#include <cmath>
#include <cstddef>

#include <Eigen/Core>

namespace citrine {

/// The beams of a spinning LiDAR: rows go up in elevation, columns left (counter-clockwise) in azimuth; the
/// sensor frame has x forward, z up. Column 0 begins at azimuth -pi. Defaults: table I of the paper, and 32 x
/// 512 beams.
struct LidarModel {
  int rows = 32;
  int cols = 512;
  double elevation_min_rad = -35.0 * EIGEN_PI / 180.0;
  double elevation_max_rad = 30.0 * EIGEN_PI / 180.0;
  double range_min_m = 0.42;
  double range_max_m = 10.0;

  std::size_t num_beams() const { return static_cast<std::size_t>(rows) * cols; }
  double row_step_rad() const {
    return rows > 1 ? (elevation_max_rad - elevation_min_rad) / (rows - 1) : 0.0;
  }
  double col_step_rad() const { return 2 * EIGEN_PI / cols; }
  double Elevation(int row) const { return elevation_min_rad + row * row_step_rad(); }
  double Azimuth(int col) const { return -EIGEN_PI + (col + 0.5) * col_step_rad(); }

  /// Unit vector of a beam in the sensor frame.
  Eigen::Vector3d Direction(int row, int col) const {
    const double el = Elevation(row), az = Azimuth(col);
    return {std::cos(el) * std::cos(az), std::cos(el) * std::sin(az), std::sin(el)};
  }

  bool operator==(const LidarModel&) const = default;
};

}  // namespace citrine

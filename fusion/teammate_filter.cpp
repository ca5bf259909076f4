#include "fusion/teammate_filter.h"

#include <cmath>

namespace citrine::fusion {
namespace {

/// [rad] of the angle under which a ball's radius is seen; all of it from inside.
double HalfAngle(double radius_m, double distance_m) {
  constexpr double kRounding_rad = 1e-6;
  return distance_m > radius_m ? std::asin(radius_m / distance_m) + kRounding_rad : EIGEN_PI;
}

}  // namespace

int DropTeammates(LidarScan& scan, const std::vector<Eigen::Vector3d>& teammates_W) {
  constexpr double kRadius_m = kAirframe_m + kTeammateMargin_m;
  int dropped = 0;
  const Pose X_SW = scan.X_WS.Inverse();
  for (const Eigen::Vector3d& teammate_W : teammates_W) {
    const Eigen::Vector3d teammate_S = X_SW * teammate_W;
    const double distance_m = teammate_S.norm();
    if (distance_m > scan.model.range_max_m + kRadius_m) continue;
    const double elevation_rad = std::asin(teammate_S.z() / distance_m);
    const double half_rad = HalfAngle(kRadius_m, distance_m);
    for (int row = 0; row < scan.model.rows; ++row) {
      if (std::abs(scan.model.Elevation(row) - elevation_rad) > half_rad) continue;
      for (int col = 0; col < scan.model.cols; ++col) {
        float& range_m = scan.ranges_m[static_cast<std::size_t>(row) * scan.model.cols + col];
        if (!(range_m > 0) || std::abs(range_m - distance_m) > kRadius_m) continue;
        if ((scan.model.Direction(row, col) * range_m - teammate_S).norm() > kRadius_m) continue;
        range_m = kInvalid;
        ++dropped;
      }
    }
  }
  return dropped;
}

}  // namespace citrine::fusion

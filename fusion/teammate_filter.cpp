#include "fusion/teammate_filter.h"

namespace citrine::fusion {

int DropTeammates(LidarScan& scan, const std::vector<Eigen::Vector3d>& teammates_W) {
  constexpr double kRadius_m = kAirframe_m + kTeammateMargin_m;
  int dropped = 0;
  const Pose X_SW = scan.X_WS.Inverse();
  for (const Eigen::Vector3d& teammate_W : teammates_W) {
    const Eigen::Vector3d teammate_S = X_SW * teammate_W;
    const double distance_m = teammate_S.norm();
    if (distance_m > scan.model.range_max_m + kRadius_m) continue;
    for (int row = 0; row < scan.model.rows; ++row)
      for (int col = 0; col < scan.model.cols; ++col) {
        float& range_m = scan.ranges_m[static_cast<std::size_t>(row) * scan.model.cols + col];
        if (!(range_m > 0) || std::abs(range_m - distance_m) > kRadius_m) continue;
        if ((scan.model.Direction(row, col) * range_m - teammate_S).norm() > kRadius_m) continue;
        range_m = kInvalid;
        ++dropped;
      }
  }
  return dropped;
}

}  // namespace citrine::fusion

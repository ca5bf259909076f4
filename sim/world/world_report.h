#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "core/quality/quality_goal.h"
#include "core/sensor/lidar_model.h"

namespace citrine::sim {

/// What a report is about: the fleet and the sensor that are to fly in the world.
struct WorldReportOptions {
  std::optional<Eigen::AlignedBox3d> volume_W;  ///< default: DefaultVolume()
  LidarModel model;
  QualityGoals goals;
  double radius_m = 1.0;
  int uavs = 3;
  std::vector<std::string> search;  ///< as of LoadWorld()
  double density_per_m2 = 25;       ///< of samples of the true surface
};

struct WorldReport {
  std::string text;  ///< lines for the terminal; what is wrong begins "! "
  bool ok = false;   ///< it can be flown in
};

/// Looks at a world file before anybody flies in it (`citrine world FILE`). Never throws WorldError: it is
/// the report.
WorldReport ReportWorld(const std::string& path, const WorldReportOptions& options = {});

}  // namespace citrine::sim

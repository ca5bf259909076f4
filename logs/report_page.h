#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "core/vehicle/vehicle_limits.h"
#include "logs/flight_measures.h"
#include "logs/flight_record.h"
#include "logs/metrics.h"
#include "logs/reconstruction_score.h"

namespace citrine::logs {

/// All that report.html shows.
struct ReportPage {
  Metrics metrics;
  FlightRecord record;
  std::vector<Series> clearance_by_uav;  ///< [m] to the true world; empty without one
  std::optional<ReconstructionScore> score;
  Series goal_coverage_pct,
      object_goal_coverage_pct;  ///< over mission time; empty: not held against the truth
  bool balance = true;           ///< planner.balance
  double d_star_m = 4.5;
  VehicleLimits limits;
  Eigen::AlignedBox3d volume_W;
  std::string config_toml;                ///< the resolved configuration
  std::string command;                    ///< the command line that flies the mission again
  std::vector<std::uint8_t> topdown_png;  ///< empty: no picture
  std::vector<std::uint8_t> mesh_png;     ///< empty: no picture
  std::vector<std::string> notes;         ///< one sentence each: what a reader of the numbers should know
};

}  // namespace citrine::logs

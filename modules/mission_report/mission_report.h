#pragma once

#include <optional>
#include <string>

#include "core/config/mission_config.h"
#include "logs/metrics.h"

namespace citrine {

/// What a report is made of beside the folder that it is written to.
struct ReportInputs {
  MissionConfig config;  ///< resolved: with volume, spawns and the world's path
  std::string log_path;
  std::string stop_reason;  ///< empty: as the log says, "interrupted" if it says nothing
  std::optional<double> wall_time_s;
  bool in_process = false;
  double pace = 1;           ///< 0: as fast as it goes
  std::string commit;        ///< empty: as the log says
  std::string command;       ///< that flies the mission again; empty: made of what the log says
  std::string cache_folder;  ///< for what can be observed of a world; empty: found anew
};

/// Reads the log, mesh.ply (or fuses the recorded scans again where there is none) and the true world, and
/// writes metrics.json, uav<i>.tum, progress.csv and report.html into `out_dir`; report.html shows
/// topdown.png if it is there. Without the world's file all is written but what needs the truth, and the
/// report says so.
/// @throws std::runtime_error naming a file that cannot be read or written
logs::Metrics WriteReport(const std::string& out_dir, const ReportInputs& inputs);

/// Inputs as far as a log itself tells them. @throws std::runtime_error, ConfigError
ReportInputs InputsFromLog(const std::string& log_path);

}  // namespace citrine

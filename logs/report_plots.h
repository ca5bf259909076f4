#pragma once

#include <string>

#include "logs/report_page.h"

namespace citrine::logs {

/// The map over mission time: surface voxels, share at the goal, active elements, Z_sat.
std::string ProgressPlots(const FlightRecord& record);

/// The fleet: paths from above, metres flown, speed, acceleration and separation over time, workload per UAV.
std::string FlightPlots(const ReportPage& page);

/// Bytes by kind of channel, and computing times of the modules.
std::string SystemPlots(const FlightRecord& record);

}  // namespace citrine::logs

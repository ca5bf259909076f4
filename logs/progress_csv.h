#pragma once

#include <string>

#include "logs/flight_measures.h"
#include "logs/flight_record.h"

namespace citrine::logs {

/// progress.csv: a line of column names, then one a MISSION_PROGRESS: time, surface voxels and how many
/// reached their goal, active elements by kind, Z of eq. (3) and (4), the known share of the volume, and the
/// metres that each UAV has flown.
std::string ProgressCsv(const FlightRecord& record);

/// One column of such a text over its first. @throws std::runtime_error naming a column that it does not have
/// or a line that is cut short
Series ColumnOverTime(const std::string& progress_csv, const std::string& column);

}  // namespace citrine::logs

#pragma once

#include "logs/metrics.h"
#include "modules/mission_report/flight_record_reader.h"
#include "modules/mission_report/mission_report.h"

namespace citrine {

/// The metrics that need no true world.
logs::Metrics MetricsOf(const Recording& recording, const ReportInputs& inputs);

}  // namespace citrine

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/fleet/fleet_status.h"
#include "core/geometry/pose.h"
#include "core/map/map_block.h"
#include "core/quality/mission_progress.h"
#include "core/time.h"
#include "core/trajectory/trajectory.h"
#include "core/vehicle/uav_state.h"

namespace citrine::logs {

template <class Noun>
struct Timed {
  Utime utime = 0;  ///< [us] mission time at which it was said
  Noun value;
};

/// What one UAV did and said, in order of time.
struct UavFlight {
  std::vector<UavState> states;    ///< every CLOCK, 50 Hz
  std::vector<Timed<Pose>> scans;  ///< X_WS of every scan
  std::vector<Timed<FleetStatus>> statuses;
  std::vector<Timed<FlightStatus>> flight_statuses;
  std::vector<Trajectory> trajectories;  ///< each id once
};

/// One mission as a recording tells it.
struct FlightRecord {
  std::vector<UavFlight> uavs;               ///< index: UAV id - 1
  std::vector<FleetAssignment> assignments;  ///< each plan once
  std::vector<Timed<MissionProgress>> progress;
  std::optional<MapSummary> map_summary;  ///< the last
  Utime end = 0;                          ///< mission time of the last CLOCK

  std::map<std::string, std::vector<float>> samples;     ///< health samples of all modules, by name
  std::map<std::string, std::int64_t> bytes_by_channel;  ///< payload
  std::int64_t messages_lost = 0;
};

}  // namespace citrine::logs

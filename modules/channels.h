#pragma once

#include <citrine_lcm/clock_t.hpp>
#include <citrine_lcm/fleet_assignment_t.hpp>
#include <citrine_lcm/fleet_status_t.hpp>
#include <citrine_lcm/flight_status_t.hpp>
#include <citrine_lcm/lidar_scan_t.hpp>
#include <citrine_lcm/map_blocks_t.hpp>
#include <citrine_lcm/map_summary_t.hpp>
#include <citrine_lcm/mission_config_t.hpp>
#include <citrine_lcm/mission_progress_t.hpp>
#include <citrine_lcm/module_health_t.hpp>
#include <citrine_lcm/octree_t.hpp>
#include <citrine_lcm/path_t.hpp>
#include <citrine_lcm/point_cloud_t.hpp>
#include <citrine_lcm/step_done_t.hpp>
#include <citrine_lcm/strategy_message_t.hpp>
#include <citrine_lcm/trajectory_t.hpp>
#include <citrine_lcm/uav_state_t.hpp>

#include "modules/runtime/bus.h"

/// Every channel of the system: its name and the one type that travels on it (table: lcmtypes/README.md).
namespace citrine::channels {

inline constexpr Channel<citrine_lcm::clock_t> kClock{"CLOCK"};
inline constexpr Channel<citrine_lcm::step_done_t> kStepDone{"STEP_DONE"};
inline constexpr UavChannel<citrine_lcm::uav_state_t> kUavState{"STATE"};
inline constexpr UavChannel<citrine_lcm::lidar_scan_t> kLidarScan{"LIDAR_SCAN"};
inline constexpr UavChannel<citrine_lcm::point_cloud_t> kPointCloud{"POINT_CLOUD"};
inline constexpr Channel<citrine_lcm::map_blocks_t> kMapBlocks{"MAP_BLOCKS"};
inline constexpr Channel<citrine_lcm::map_summary_t> kMapSummary{"MAP_SUMMARY"};
inline constexpr Channel<citrine_lcm::octree_t> kMapOctree{"MAP_OCTREE"};
inline constexpr Channel<citrine_lcm::mission_progress_t> kMissionProgress{"MISSION_PROGRESS"};
inline constexpr UavChannel<citrine_lcm::fleet_status_t> kFleetStatus{"FLEET_STATUS"};
inline constexpr Channel<citrine_lcm::fleet_assignment_t> kFleetAssignment{"FLEET_ASSIGNMENT"};
inline constexpr UavChannel<citrine_lcm::strategy_message_t> kStrategy{"STRATEGY"};
inline constexpr UavChannel<citrine_lcm::path_t> kPath{"PATH"};
inline constexpr UavChannel<citrine_lcm::trajectory_t> kTrajectory{"TRAJECTORY"};
inline constexpr UavChannel<citrine_lcm::flight_status_t> kFlightStatus{"FLIGHT_STATUS"};
inline constexpr Channel<citrine_lcm::mission_config_t> kMissionConfig{"MISSION_CONFIG"};
inline constexpr Channel<citrine_lcm::module_health_t> kModuleHealth{"MODULE_HEALTH"};

}  // namespace citrine::channels

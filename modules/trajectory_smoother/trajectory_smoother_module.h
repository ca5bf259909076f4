#pragma once

#include <memory>
#include <optional>

#include <citrine_lcm/lidar_scan_t.hpp>
#include <citrine_lcm/path_t.hpp>
#include <citrine_lcm/trajectory_t.hpp>
#include <citrine_lcm/uav_state_t.hpp>

#include "core/fleet/fleet_status.h"
#include "modules/runtime/module.h"
#include "planner/safety/flight_executive.h"

namespace citrine {

/// Flies one UAV: hears its path, scans and state, the fleet's trajectories and the map; says
/// UAV<i>_TRAJECTORY on event and at 2 Hz, UAV<i>_FLIGHT_STATUS on change and at 5 Hz. What it decides is
/// planner/safety's.
class TrajectorySmootherModule : public Module {
 public:
  static constexpr const char* kName = "trajectory_smoother";
  static constexpr const char* kSummary = "smooths a UAV's path within its limits and guards its flight";
  static constexpr bool kHearsMap = true;
  static constexpr bool kPerUav = true;

  explicit TrajectorySmootherModule(const ModuleContext& context);

  void Tick(const Step& step) override;

 private:
  void HearAll();
  void SayTrajectory(Utime now);
  void SayStatus(Utime now);

  Bus& bus_;
  Health& health_;
  const int uav_;
  std::shared_ptr<MapHearer> map_hearer_;
  planner::FlightExecutive executive_;
  std::shared_ptr<Inbox<citrine_lcm::path_t>> paths_;
  std::shared_ptr<Inbox<citrine_lcm::lidar_scan_t>> scans_;
  std::shared_ptr<Inbox<citrine_lcm::uav_state_t>> states_;
  std::shared_ptr<Inbox<citrine_lcm::trajectory_t>> trajectories_;
  Every trajectory_due_{0.5}, status_due_{0.2};
  std::int64_t said_trajectory_ = 0;
  std::optional<FlightStatus> said_status_;
};

}  // namespace citrine

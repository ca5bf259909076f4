#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <citrine_lcm/fleet_status_t.hpp>
#include <citrine_lcm/map_summary_t.hpp>
#include <citrine_lcm/trajectory_t.hpp>

#include "core/random.h"
#include "modules/runtime/module.h"
#include "modules/uav_dynamics/mission_end.h"
#include "sim/dynamics/fleet_simulator.h"

namespace citrine {

/// The fleet's bodies: hears UAV<i>_TRAJECTORY, says UAV<i>_STATE in every step, and knows when the mission
/// is over.
class UavDynamicsModule : public Module {
 public:
  static constexpr const char* kName = "uav_dynamics";
  static constexpr const char* kSummary =
      "simulates the UAVs in the Open Dynamics Engine and ends the mission";
  static constexpr bool kHearsMap = false;
  static constexpr bool kPerUav = false;

  /// @throws ConfigError unless mission.spawns_m names one place a UAV; sim::WorldError for a world that
  /// cannot be used
  explicit UavDynamicsModule(const ModuleContext& context);

  void Tick(const Step& step) override;

  /// Why the mission is over, "surface_complete" or "time_limit"; nothing while it goes on. It stays once
  /// said.
  const std::optional<std::string>& stop_reason() const { return stop_reason_; }

 private:
  void HearTrajectories();
  void HearTheEnd(Utime now);
  void SayStates();

  Bus& bus_;
  Health& health_;
  double localisation_noise_m_;
  sim::FleetSimulator fleet_;
  MissionEnd end_;
  std::optional<std::string> stop_reason_;
  Utime simulated_ = 0;
  std::vector<std::optional<Trajectory>> newest_trajectory_;  ///< by UAV id - 1
  std::vector<Random> localisation_;                          ///< by UAV id - 1
  std::shared_ptr<Inbox<citrine_lcm::trajectory_t>> trajectories_;
  std::shared_ptr<Inbox<citrine_lcm::fleet_status_t>> fleet_statuses_;
  std::shared_ptr<Inbox<citrine_lcm::map_summary_t>> map_summaries_;
};

}  // namespace citrine

#pragma once

#include <memory>
#include <optional>

#include "modules/channels.h"
#include "modules/runtime/module.h"
#include "planner/path/path_search.h"
#include "planner/strategy/view_planner.h"

namespace citrine {

/// One UAV's planner on the bus: hears the fleet, the map and its own flight; says its status, the path to
/// the view that it has chosen, and corrections of the fleet's balance.
class ViewPlannerModule : public Module {
 public:
  static constexpr const char* kName = "view_planner";
  static constexpr const char* kSummary = "decides where one UAV looks next";
  static constexpr bool kHearsMap = true;
  static constexpr bool kPerUav = true;

  explicit ViewPlannerModule(const ModuleContext& context);
  void Tick(const Step& step) override;
  void TellDecisions(planner::HearDecision hear) { planner_.TellDecisions(std::move(hear)); }

 private:
  void HearAll(Utime now);
  void Say(const planner::ViewPlanner::Outcome& outcome, Utime now);
  std::optional<Path> FindPath(const Eigen::Vector3d& start_W, const Eigen::Vector3d& goal_W,
                               const std::vector<PlanningMap::Ball>& avoid);

  Bus& bus_;
  Health& health_;
  int uav_;
  std::shared_ptr<MapHearer> map_hearer_;
  planner::PathSearch path_search_;
  planner::ViewPlanner planner_;

  std::shared_ptr<Inbox<citrine_lcm::uav_state_t>> states_;
  std::shared_ptr<Inbox<citrine_lcm::fleet_status_t>> statuses_;
  std::shared_ptr<Inbox<citrine_lcm::fleet_assignment_t>> assignments_;
  std::shared_ptr<Inbox<citrine_lcm::flight_status_t>> flights_;
  std::shared_ptr<Inbox<citrine_lcm::trajectory_t>> trajectories_;

  Every status_{0.2}, path_again_{0.5}, assignment_again_{0.5};
  FleetStatus said_;
  double path_ms_ = 0;  ///< of the path searches in the present step
};

}  // namespace citrine

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "modules/channels.h"
#include "modules/runtime/module.h"
#include "modules/runtime/module_kind.h"

namespace citrine {

inline constexpr int kToySteps = 40;

/// Depends on all that was heard, in this order, and on how often.
inline std::int64_t Mixed(std::int64_t sum, int factor, std::int64_t heard) {
  return (factor * sum + heard) % 1000003;
}

/// Stands in for uav_dynamics: owns the time, answers paths with states. What it says depends on all that it
/// has heard.
class ToyDynamics : public Module {
 public:
  static constexpr const char* kName = "uav_dynamics";
  static constexpr const char* kSummary = "Owns the time of a toy mission.";
  static constexpr bool kHearsMap = false;
  static constexpr bool kPerUav = false;

  explicit ToyDynamics(const ModuleContext& context)
      : context_(context), paths_(context.bus.HearAll(channels::kPath)) {}
  void Tick(const Step& step) override {
    step_ = step;
    for (const auto& entry : paths_->Take()) sum_ = Mixed(sum_, 31, 7 * entry.message.path_id + entry.uav);
    for (int uav = 1; uav <= context_.config.mission.uavs; ++uav) {
      citrine_lcm::uav_state_t state{};
      state.p_WB[0] = static_cast<double>(sum_);
      context_.bus.Publish(channels::kUavState, uav, state);
    }
  }
  std::optional<std::string> stop_reason() const {
    return step_.index + 1 >= kToySteps ? std::optional<std::string>("surface_complete") : std::nullopt;
  }

 private:
  const ModuleContext context_;
  std::shared_ptr<Inbox<citrine_lcm::path_t>> paths_;
  Step step_;
  std::int64_t sum_ = 1;
};

/// Stands in for any other module: one a UAV or one for all; says paths that depend on the states and
/// assignments heard.
template <const char* kToyName, bool kToyPerUav>
class ToyFollower : public Module {
 public:
  static constexpr const char* kName = kToyName;
  static constexpr const char* kSummary = "Follows the time of a toy mission.";
  static constexpr bool kHearsMap = false;
  static constexpr bool kPerUav = kToyPerUav;

  explicit ToyFollower(const ModuleContext& context)
      : context_(context),
        states_(context.bus.HearAll(channels::kUavState)),
        assignments_(context.bus.Hear(channels::kFleetAssignment)) {}
  void Tick(const Step& step) override {
    for (const auto& entry : states_->Take())
      sum_ = Mixed(sum_, 17, static_cast<std::int64_t>(entry.message.p_WB[0]) + entry.uav);
    for (const auto& entry : assignments_->Take())
      sum_ = Mixed(sum_, 13, entry.message.plan_id + entry.message.sender);
    if (!kToyPerUav || step.index % 2 == 1) return;
    citrine_lcm::path_t path{};
    path.path_id = sum_;
    if (std::string(kToyName) == "view_planner") context_.bus.Publish(channels::kPath, context_.uav, path);
    citrine_lcm::fleet_assignment_t assignment{};
    assignment.plan_id = sum_;
    assignment.sender = context_.uav;
    if (std::string(kToyName) == "view_planner") context_.bus.Publish(channels::kFleetAssignment, assignment);
    context_.health.Sample("toy_ms", 1);
  }

 private:
  const ModuleContext context_;
  std::shared_ptr<Inbox<citrine_lcm::uav_state_t>> states_;
  std::shared_ptr<Inbox<citrine_lcm::fleet_assignment_t>> assignments_;
  std::int64_t sum_ = 3;
};

inline constexpr char kToyLidar[] = "lidar_emulator";
inline constexpr char kToyFusion[] = "map_fusion";
inline constexpr char kToyPlanner[] = "view_planner";
inline constexpr char kToySmoother[] = "trajectory_smoother";
inline constexpr char kToyRenderer[] = "topdown_renderer";

/// The modules of a mission, each a toy.
inline std::vector<ModuleKind> ToyKinds() {
  return {KindOf<ToyDynamics>(),
          KindOf<ToyFollower<kToyLidar, false>>(),
          KindOf<ToyFollower<kToyFusion, false>>(),
          KindOf<ToyFollower<kToyPlanner, true>>(),
          KindOf<ToyFollower<kToySmoother, true>>(),
          KindOf<ToyFollower<kToyRenderer, false>>()};
}

}  // namespace citrine

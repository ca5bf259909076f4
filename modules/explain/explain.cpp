#include "modules/explain/explain.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <stdexcept>

#include "modules/channels.h"
#include "modules/codec/bad_message.h"
#include "modules/codec/fleet_status.h"
#include "modules/explain/decision_text.h"
#include "modules/replay/replay.h"
#include "modules/topdown_renderer/scene_hearer.h"
#include "modules/view_planner/view_planner_module.h"
#include "viz/topdown_renderer.h"

namespace citrine {
namespace {

constexpr double kSame_m = 0.01;  ///< between a goal and itself after its journey over the wire

/// A planner, and somebody beside it who sees what it sees.
class WatchedPlanner : public Module {
 public:
  WatchedPlanner(const ModuleContext& context, std::int64_t number, int rows, Explanation& explanation,
                 Eigen::Vector3d& goal_W)
      : config_(context.config), scene_(context), planner_(context) {
    planner_.TellDecisions([this, number, rows, &explanation, &goal_W](const planner::Decision& decision) {
      explanation.decisions = decision.number;
      if (decision.number != number) return;
      explanation.found = true;
      explanation.text = DecisionText(decision, rows);
      explanation.picture = Picture(decision);
      goal_W = decision.situation.views[decision.chosen].p_W;
    });
  }
  void Tick(const Step& step) override {
    scene_.Update(step);
    planner_.Tick(step);
  }

 private:
  viz::Image Picture(const planner::Decision& decision) {
    viz::Scene scene = scene_.Finish();
    const auto [least, most] =
        std::minmax_element(decision.scores.begin(), decision.scores.end(),
                            [](const auto& a, const auto& b) { return a.total < b.total; });
    const double span = std::max(most->total - least->total, 1e-9);
    for (std::size_t i = 0; i < decision.scores.size(); ++i) {
      const planner::View& view = decision.situation.views[i];
      scene.candidates.push_back(
          {view.p_W, view.element_W, (decision.scores[i].total - least->total) / span, i == decision.chosen});
    }
    return viz::TopdownRenderer(config_.volume_W(), config_.viz.pixels_per_m).Draw(scene);
  }

  const MissionConfig& config_;
  SceneHearer scene_;
  ViewPlannerModule planner_;
};

/// Whether a recording says that a UAV's n-th selection was this goal.
bool Recorded(const std::vector<LogEvent>& events, int uav, std::int64_t number,
              const Eigen::Vector3d& goal_W) {
  for (const LogEvent& event : events) {
    if (event.channel != channels::kFleetStatus.Of(uav)) continue;
    citrine_lcm::fleet_status_t message{};
    try {
      if (message.decode(event.bytes.data(), 0, static_cast<int>(event.bytes.size())) < 0) continue;
      const FleetStatus status = Decode(message);
      if (status.decisions == number && status.has_goal) return (status.goal_W - goal_W).norm() < kSame_m;
    } catch (const std::exception&) {  // damaged: it is said again
    }
  }
  return false;
}

}  // namespace

Explanation Explain(const RecordedMission& mission, int uav, std::int64_t number, int rows,
                    const std::function<bool()>& interrupted) {
  Explanation explanation;
  Eigen::Vector3d goal_W;
  ModuleKind kind = KindOf<ViewPlannerModule>();
  kind.make = [&](const ModuleContext& context) {
    return std::make_unique<WatchedPlanner>(context, number, rows, explanation, goal_W);
  };
  const Replayed replayed = Replay(mission.events, mission.config, kind, uav, 0,
                                   [&] { return explanation.found || (interrupted && interrupted()); });
  if (!replayed.error.empty()) throw std::runtime_error(replayed.error);
  if (explanation.found) explanation.as_recorded = Recorded(mission.events, uav, number, goal_W);
  return explanation;
}

}  // namespace citrine

#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/map/planning_map.h"
#include "core/quality/quality_goal.h"
#include "planner/view/elements.h"
#include "planner/view/sensor_window.h"
#include "planner/view/view.h"
#include "planner/view/view_score.h"

namespace citrine::planner {

/// What a UAV decides on. All strategies share the map, the elements and the candidate views: what differs is
/// the choice.
struct Situation {
  const PlanningMap& map;
  const QualityGoals& goals;
  const SensorWindow& window;
  double eta_m;
  const std::vector<Element>& elements;  ///< active, ascending by voxel
  const std::vector<View>& views;        ///< candidates, ascending by element
  int uav;
  Eigen::Vector3d p_W;                    ///< where the way to the view begins [m]
  Eigen::Vector3d v_W;                    ///< [m/s]
  std::vector<Eigen::Vector3d> others_W;  ///< goals of the other UAVs, positions of those without [m]
  const std::vector<Eigen::Vector3d>*
      centroid_W_by_uav;  ///< of an imbalance correction that holds; else null
};

/// Decides which view to fly to next.
class Strategy {
 public:
  virtual ~Strategy() = default;
  using Accept = std::function<bool(const View&)>;
  /// Offers views to `accept`, best first, until it takes one.
  /// @return its index in the situation's views. nullopt: it took none of those offered
  virtual std::optional<std::size_t> Choose(const Situation& situation, const Accept& accept) = 0;
  /// What it makes of every view; the one with the largest total, the first of equals, is offered first.
  virtual std::vector<Score> Scores(const Situation& situation) const = 0;
};

/// Views offered at most in one decision.
inline constexpr int kOffers = 5;

}  // namespace citrine::planner

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/fleet/fleet_status.h"
#include "core/map/planning_map.h"
#include "core/quality/mission_progress.h"
#include "core/quality/quality_goal.h"
#include "core/time.h"
#include "core/trajectory/path.h"
#include "core/trajectory/trajectory.h"
#include "core/vehicle/uav_state.h"

namespace citrine::viz {

/// One UAV as it is drawn.
struct SceneUav {
  int id = 1;
  UavState state;
  std::vector<Eigen::Vector3d> trail_W;  ///< where it has been, oldest first
  double flown_m = 0;
  std::optional<Path> path;                   ///< the way to the goal as the planner said it
  std::optional<Trajectory> trajectory;       ///< as the smoother committed to it
  std::optional<FleetStatus> status;          ///< with the goal
  std::optional<Eigen::Vector3d> centroid_W;  ///< under a correction of the fleet's balance
};

/// What a picture of a mission shows at one instant; nouns alone.
struct Scene {
  std::string mission, strategy;
  Utime now = 0;
  const PlanningMap* map = nullptr;  ///< null: no map yet
  QualityGoals goals;
  double uav_radius_m = 1.0;
  double ceiling_m = 1e3;  ///< surfaces above it are not drawn
  std::vector<SceneUav> uavs;
  std::vector<Eigen::Vector3f> incomplete_W;   ///< active elements: ISE
  std::vector<Eigen::Vector3f> low_quality_W;  ///< active elements: LQSE
  /// A view that was to choose from, where a decision is explained.
  struct Candidate {
    Eigen::Vector3d p_W = Eigen::Vector3d::Zero();
    Eigen::Vector3d element_W = Eigen::Vector3d::Zero();
    double share = 0;  ///< of the highest score
    bool chosen = false;
  };
  std::vector<Candidate> candidates;
  MissionProgress progress;
  struct Reached {
    double time_s = 0;
    double share = 0;  ///< of the surface voxels, those at their goal
  };
  std::vector<Reached> history;  ///< of the progress, oldest first
};

}  // namespace citrine::viz

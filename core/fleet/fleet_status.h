#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/geometry/pose.h"
#include "core/time.h"

namespace citrine {

/// What one UAV tells the fleet: the pose, the committed next view and the flag of section IV of the paper,
/// whole.
struct FleetStatus {
  enum class Activity : std::int8_t { kIdle = 0, kDeciding = 1, kFlying = 2 };

  Pose X_WB;
  Activity activity = Activity::kIdle;
  Utime deciding_since = 0;  ///< [us] when the decision under way was triggered
  bool has_goal = false;     ///< without a goal a UAV counts with its position
  Eigen::Vector3d goal_W = Eigen::Vector3d::Zero();
  double goal_yaw_rad = 0;
  std::int64_t decisions = 0;         ///< decisions made so far
  bool replanning = false;            ///< balancing the fleet; nobody else may begin (section IV-C)
  std::int64_t plan_id = 0;           ///< newest fleet assignment known, 0 none
  int corrected_selections_left = 0;  ///< of the k selections under that assignment
  std::int64_t map_version = 0;       ///< of the map on which the last decision was made
  std::int32_t elements_active = 0;
  std::int32_t elements_unreachable = 0;
  std::int32_t elements_given_up = 0;
  bool no_view_left = false;
};

/// Centroids of a balanced fleet (section IV-C), valid until every UAV has made its k selections or it
/// expires.
struct FleetAssignment {
  std::int64_t plan_id = 0;  ///< utime of the correction x 16 + sender: unique, and the larger is the newer
  int sender = 0;
  Utime expiry = 0;
  int selections = 2;                              ///< k
  std::vector<Eigen::Vector3d> centroid_W_by_uav;  ///< index: UAV id - 1
};

/// What a smoother tells its planner.
struct FlightStatus {
  enum class Phase : std::int8_t { kWaiting = 0, kTracking = 1, kReached = 2, kBraking = 3, kBlocked = 4 };

  Phase phase = Phase::kWaiting;
  std::int64_t path_id = 0;  ///< the path that this is about
  std::int64_t trajectory_id = 0;
  double time_to_go_s = 0;  ///< until the committed trajectory is at rest
  double distance_to_go_m = 0;
  int failures = 0;    ///< consecutive ones of this path
  std::string reason;  ///< why it brakes or is blocked; empty otherwise
};

}  // namespace citrine

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/map/planning_map.h"
#include "core/vehicle/vehicle_limits.h"

namespace citrine::planner {

using Ball = PlanningMap::Ball;

/// What unknown space counts as.
enum class Unknown { kObstacle, kFree };

/// Where a UAV may be: inside the mission volume, with a ball of its radius around it known to be free.
///
/// Reads the map's distance fields; holds no copy. A clearance that the fields cannot express is cut to their
/// reach.
class SafeSpace {
 public:
  /// @param margin_m clearance to occupied space beyond the robot's radius; to unknown space none
  SafeSpace(const PlanningMap& map, const VehicleLimits& limits, double margin_m,
            Unknown unknown = Unknown::kObstacle);

  bool SafeVoxel(const VoxelIndex& v) const {
    return map_.grid().Inside(v) && SafeVoxel(map_.grid().Linear(v));
  }
  /// As above for a voxel that is inside the mission volume.
  bool SafeVoxel(std::size_t linear) const {
    return map_.to_occupied().squared_vox(linear) >= occupied_vox2_ &&
           map_.to_unknown().squared_vox(linear) >= unknown_vox2_;
  }
  /// The same for voxels `first + begin` to `first + end` of a row of the grid inside the mission volume, one
  /// bit each from bit `begin` on; 64 at most.
  std::uint64_t SafeVoxels(std::size_t first, int begin, int end) const;
  /// Free of obstacles, as far as is known: unknown space passes.
  bool OpenVoxel(std::size_t linear) const {
    return map_.to_occupied().squared_vox(linear) >= occupied_vox2_;
  }
  /// Clear of obstacles by half a metre more than is asked.
  bool RoomyVoxel(std::size_t linear) const { return map_.to_occupied().squared_vox(linear) >= roomy_vox2_; }

  /// [m] by how much the clearance at a point exceeds what is asked, between voxels too; negative: not safe.
  double Slack(const Eigen::Vector3d& p_W) const;
  /// Whether that is not negative.
  bool Safe(const Eigen::Vector3d& p_W) const;
  /// [m] clearance to everything occupied or unknown.
  double FreeRadius(const Eigen::Vector3d& p_W) const;
  /// Whether a straight leg is safe throughout, by sphere tracing, and stays out of the balls.
  bool LegSafe(const Eigen::Vector3d& from_W, const Eigen::Vector3d& to_W,
               const std::vector<Ball>& avoid = {}) const;

  /// The safe voxel whose centre is nearest to a point, the lowest index of equals. nullopt: none within
  /// `reach_m`
  std::optional<VoxelIndex> NearestSafeVoxel(const Eigen::Vector3d& p_W, double reach_m) const;

  const PlanningMap& map() const { return map_; }

 private:
  const PlanningMap& map_;
  double occupied_m_, unknown_m_;
  std::uint16_t occupied_vox2_, unknown_vox2_, roomy_vox2_;
};

}  // namespace citrine::planner

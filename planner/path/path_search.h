#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/trajectory/path.h"
#include "planner/path/lattice_search.h"
#include "planner/path/reachable_set.h"

namespace citrine::planner {

/// Ways through space known to be free: A* over voxels, then straight legs by sphere tracing (paper, IV-E).
class PathSearch {
 public:
  /// @param margin_m clearance to occupied space beyond the robot's radius
  PathSearch(const PlanningMap& map, const VehicleLimits& limits, double margin_m);
  /// @param reachable  with the same limits and margin; shared with others, who bring it up to date as well
  PathSearch(std::shared_ptr<ReachableSet> reachable, const VehicleLimits& limits, double margin_m);

  /// The way from a start to a goal. A start that is not safe first goes to the nearest safe place. A goal
  /// that cannot be reached is replaced by the furthest reachable point of the best way that would be
  /// possible if unknown space were free (Path::ends_at_goal = false). `id` and `goal_yaw_rad` are the
  /// caller's to set.
  /// @param avoid balls that the way stays out of, such as hovering teammates
  /// @return nullopt: unreachable, even if all that is unknown were free, or no nearer to it than the start
  /// is
  std::optional<Path> Find(const Eigen::Vector3d& start_W, const Eigen::Vector3d& goal_W,
                           const std::vector<Ball>& avoid = {});

  /// The safe voxels connected to the last start.
  const ReachableSet& reachable() const { return *reachable_; }

 private:
  /// Voxel centres of the way between two voxels; empty: none.
  std::vector<VoxelIndex> WayTo(const VoxelIndex& from, const VoxelIndex& to, const std::vector<Ball>& avoid);
  std::vector<VoxelIndex> WayTowards(const VoxelIndex& from, const Eigen::Vector3d& goal_W,
                                     const std::vector<Ball>& avoid);
  std::vector<Eigen::Vector3d> Shorten(const std::vector<Eigen::Vector3d>& points_W,
                                       const std::vector<Ball>& avoid) const;

  VehicleLimits limits_;
  std::shared_ptr<ReachableSet> reachable_;
  ReachableSet hopeful_;  ///< through unknown space
  LatticeSearch coarse_, fine_;
};

}  // namespace citrine::planner

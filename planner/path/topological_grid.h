#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/map/planning_map.h"

namespace citrine::planner {

/// Cells of four voxels a side that are for the most part known to be free, as neighbours over faces, edges
/// and corners: how far it is from here to there, roughly, for the assignment of a balanced fleet (paper,
/// IV-C).
class TopologicalGrid {
 public:
  explicit TopologicalGrid(const PlanningMap& map);

  /// [m] from each of several points (a row) to each of others (a column), through the centres of free cells.
  /// A point in a cell that is not free (a centroid may lie in a wall) is joined to the nearest free cell by
  /// a straight line. Infinity: not connected.
  Eigen::MatrixXd LengthsBetween(const std::vector<Eigen::Vector3d>& from_W,
                                 const std::vector<Eigen::Vector3d>& to_W);

 private:
  struct Neighbour {
    int cells;  ///< on, in memory
    double length_m;
  };
  void ReadMap();
  /// One row of LengthsBetween. @param ends  the nearest free cells to `to_W`
  Eigen::RowVectorXd LengthsFrom(const Eigen::Vector3d& from_W, const std::vector<Eigen::Vector3d>& to_W,
                                 const std::vector<int>& ends) const;
  int CellOf(const Eigen::Vector3d& p_W) const;
  Eigen::Vector3d Centre(int cell) const;
  int NearestFree(const Eigen::Vector3d& p_W) const;  ///< -1: there is none

  const PlanningMap& map_;
  Eigen::Vector3i size_;  ///< with a border of one cell, which is never free
  double cell_m_;
  std::array<Neighbour, 26> neighbours_;
  std::vector<std::uint8_t> free_;
  std::int64_t revision_ = -1;
};

}  // namespace citrine::planner

#pragma once

#include <cstdint>
#include <vector>

#include "core/grid/voxel_grid.h"

namespace citrine::planner {

/// A* over every `stride`-th voxel with 26 neighbours and the exact distance of an empty lattice as its
/// heuristic. Integer costs and a total order of the open list: the same way on every machine. Arrays are
/// reused between calls.
class LatticeSearch {
 public:
  LatticeSearch(const VoxelGrid& grid, int stride);

  /// @param cost (voxel, linear) -> 0: closed, else what a step into it costs relative to `kUnitCost`. Also
  /// asked halfway
  ///        between nodes if the stride is even.
  /// @param tolerance_vox the goal is met within this many voxels along every axis
  /// @return the nodes from `from` to the goal; empty: there is no way, or none was found in `closed_max`
  /// nodes
  template <class Cost>
  std::vector<VoxelIndex> Find(const VoxelIndex& from, const VoxelIndex& to, int tolerance_vox,
                               int closed_max, Cost&& cost);

  /// Where the last search got nearest to its goal, if it ended for want of nodes; empty if it had looked
  /// everywhere.
  std::vector<VoxelIndex> WayToNearest() const;

  static constexpr std::uint32_t kUnitCost = 4;

 private:
  struct Open {
    std::uint32_t estimate, travelled, node;
  };
  struct Node {
    std::uint32_t round = 0;  ///< of the search that wrote it
    std::uint32_t travelled = 0;
    std::int8_t from = -1;  ///< index into kN26 of the step that led here, -1 at the start
    bool closed = false;
  };

  void Begin(const VoxelIndex& from);
  std::uint32_t NodeOf(const VoxelIndex& v) const;
  VoxelIndex VoxelOf(std::uint32_t node) const;
  void Push(Open entry);
  Open Pop();
  std::vector<VoxelIndex> Trace(std::uint32_t node) const;
  /// Cost of the shortest way over an empty lattice, slightly raised so that fewer nodes are opened.
  std::uint32_t Heuristic(const VoxelIndex& v, const VoxelIndex& to) const;

  VoxelGrid grid_;
  int stride_;
  VoxelIndex offset_ = VoxelIndex::Zero();  ///< of the lattice, so that the start is a node
  VoxelIndex size_;
  std::uint32_t round_ = 0;
  std::vector<Node> nodes_;
  std::uint32_t nearest_ = 0, nearest_estimate_ = 0;  ///< of the last search, and what it lacks to the goal
  std::vector<Open> open_;
};

}  // namespace citrine::planner

#include "planner/path/lattice_search.inl"

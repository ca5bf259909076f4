#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/map/planning_map.h"
#include "core/quality/quality_goal.h"

namespace citrine {

/// What a voxel is to the surface. An incomplete element is empty and a surface voxel is not, so none is two
/// things.
enum class SurfaceClass : std::uint8_t {
  kNone = 0,
  kReached = 1,  ///< surface voxel (M_S) whose weight has reached w* of its region
  kLqse = 2,     ///< surface voxel below it: low quality surface element (definition 3)
  kIse = 3,      ///< incomplete surface element (definition 1)
};

/// The active surface elements of a planning map: ISE and LQSE inside the mission volume (paper, section
/// III).
///
/// ISE: empty, unknown in N6, occupied in N18. Surface voxel: known, |d| < d_s, empty in N6. Voxels outside
/// the volume count as neither. Follows the map block by block and equals a computation from scratch.
class ActiveSurface {
 public:
  ActiveSurface(const VoxelGrid& grid, const Quantisation& quantisation, QualityGoals goals);

  /// Follows the map: looks again at every block whose version has changed and at the voxels around it.
  /// @return whether a block had changed
  bool Update(const PlanningMap& map);

  /// Linear indices of all ISE and LQSE, ascending, each once.
  const std::vector<std::uint32_t>& elements() const { return elements_; }
  SurfaceClass At(std::size_t linear) const { return static_cast<SurfaceClass>(class_[linear]); }
  const std::vector<std::uint8_t>& classes() const { return class_; }

  /// Number of voxels of a class (not of kNone).
  std::int32_t Count(SurfaceClass c) const { return counts_[static_cast<int>(c)]; }

  /// Map revision at which a block last lost an unknown voxel; 0 if never. It grows finitely often.
  std::int64_t discovered(int block) const { return discovered_[block]; }
  /// Newest of these.
  std::int64_t last_discovery() const { return last_discovery_; }

  const QualityGoals& goals() const { return goals_; }
  const VoxelGrid& grid() const { return grid_; }

 private:
  struct Neighbourhood;
  void Recompute(const PlanningMap& map, int block);
  std::int32_t CountUnknown(const PlanningMap& map, const VoxelIndex& origin) const;
  void WriteRow(const PlanningMap& map, const VoxelIndex& first, int count, unsigned incomplete,
                unsigned surface);
  int ReachedCode(const VoxelIndex& v) const;
  void List();

  VoxelGrid grid_;
  QualityGoals goals_;
  int band_first_ = 256, band_last_ = 0;  ///< distance codes of known voxels with |d| < d_s
  int reached_code_whole_ = 255;          ///< lowest weight code that reaches w*
  std::vector<int> reached_code_of_region_;
  std::vector<std::uint8_t> class_;
  std::vector<std::int32_t> active_in_row_;  ///< elements in each row of voxels along x
  std::array<std::int32_t, 4> counts_{};
  std::vector<std::uint32_t> elements_;
  std::vector<std::uint32_t> version_;  ///< of the blocks as last looked at
  std::vector<std::int32_t> unknown_;   ///< unknown voxels of each block
  std::vector<std::int64_t> discovered_;
  std::int64_t last_discovery_ = 0;
};

}  // namespace citrine

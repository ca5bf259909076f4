#pragma once

#include <vector>

#include "core/map/tsdf_map.h"
#include "core/sensor/lidar_scan.h"
#include "fusion/lanes.h"
#include "fusion/range_image.h"
#include "fusion/voxel_observer.h"
#include "fusion/weight_policy.h"

namespace citrine::fusion {

/// Fuses one scan at a time into a TSDF, voxel by voxel: each voxel of each block within range is projected
/// into the scan's range image and observed once (projective integration; Curless & Levoy 1996 for the
/// averaging).
///
/// Blocks that the image shows to lie behind what was seen are skipped, and blocks in front of everything are
/// filled without looking their voxels up. A surface once seen well is kept from free rays that graze it from
/// afar.
class TsdfIntegrator {
 public:
  TsdfIntegrator(TsdfMap& map, WeightPolicy policy) : map_(map), policy_(policy) {}

  /// @return the blocks in which anything changed that could be said, ascending
  std::vector<int> Integrate(const LidarScan& scan);

 private:
  enum class Sight { kNone, kFree, kMixed };
  struct View;
  Sight SightOf(const View& view, const Eigen::Vector3d& centre_S, double radius_m, float* farthest_m) const;
  bool Fill(TsdfBlock& block, float weight) const;
  bool Observe(const View& view, const VoxelIndex& origin, TsdfBlock& block) const;
  bool Fuse(const Observation& observation, int row, TsdfBlock& block) const;
  void CountPoints(const LidarScan& scan, std::vector<int>& changed);

  TsdfMap& map_;
  WeightPolicy policy_;
};

}  // namespace citrine::fusion

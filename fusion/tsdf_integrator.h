#pragma once

#include <cstdint>
#include <vector>

#include "core/map/tsdf_map.h"
#include "core/sensor/lidar_scan.h"
#include "fusion/brick_finder.h"
#include "fusion/brick_fuser.h"
#include "fusion/range_bounds.h"
#include "fusion/range_image.h"
#include "fusion/scan_view.h"
#include "fusion/weight_policy.h"

namespace citrine::fusion {

/// Fuses one scan at a time into a TSDF, voxel by voxel: each voxel of each block within range is projected
/// into the scan's range image and observed once (projective integration).
///
/// Blocks, and bricks of blocks, that the image shows to lie behind what was seen are skipped, and so are
/// those that beams pass without a return nearby if all of them is known as free. The map is the same to the
/// bit as if every voxel were looked up.
class TsdfIntegrator {
 public:
  /// @param parts  of the blocks of a scan, for threads to take; the map is the same to the bit for any
  /// number
  TsdfIntegrator(TsdfMap& map, WeightPolicy policy, int parts = 1);

  /// @return the blocks in which anything changed that could be said, ascending
  std::vector<int> Integrate(const LidarScan& scan);

 private:
  void FindCandidates(const ScanView& view);
  /// Of the candidates from `begin` to `end`.
  void IntegrateBlocks(const ScanView& view, int begin, int end, BrickFinder& finder);
  void CountPoints(const LidarScan& scan, std::vector<int>& changed);

  TsdfMap& map_;
  WeightPolicy policy_;
  int parts_;
  BrickFuser fuser_;
  RangeImage image_;
  RangeBounds bounds_;
  std::vector<int> candidates_;        ///< blocks of which the scan may tell something
  std::vector<std::uint8_t> changed_;  ///< one a candidate
};

}  // namespace citrine::fusion

#pragma once

#include <vector>

#include "core/map/tsdf_map.h"
#include "core/sensor/lidar_scan.h"
#include "fusion/brick_fuser.h"
#include "fusion/range_bounds.h"
#include "fusion/range_image.h"

namespace citrine::test {

/// Looks every voxel of every block up in the image of a scan: what the integrator, which skips, is to equal
/// to the bit.
class VoxelIntegrator {
 public:
  VoxelIntegrator(TsdfMap& map, fusion::WeightPolicy policy)
      : map_(map), fuser_(map.truncation_m(), policy) {}

  /// @return the blocks in which anything changed that could be said, ascending
  std::vector<int> Integrate(const LidarScan& scan);

 private:
  TsdfMap& map_;
  fusion::BrickFuser fuser_;
  fusion::RangeImage image_;
  fusion::RangeBounds bounds_;
};

}  // namespace citrine::test

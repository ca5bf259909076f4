#include "tests/support/ray_integrator.h"

#include <algorithm>

#include "core/grid/ray_walk.h"

namespace citrine::test {

void RayIntegrator::Integrate(const LidarScan& scan) {
  const VoxelGrid& grid = map_.grid();
  const double truncation_m = map_.truncation_m();
  for (int row = 0; row < scan.model.rows; ++row)
    for (int col = 0; col < scan.model.cols; ++col) {
      const float range_m = scan.ranges_m[static_cast<std::size_t>(row) * scan.model.cols + col];
      if (range_m < 0) continue;
      const bool returned = range_m > 0;
      const double surface_m = returned ? range_m : scan.model.range_max_m;
      const Eigen::Vector3d along = scan.X_WS.q * scan.model.Direction(row, col);
      const Eigen::Vector3d end_W = scan.X_WS.p + along * (surface_m + (returned ? truncation_m : 0));
      WalkRay(grid, scan.X_WS.p, end_W, [&](const VoxelIndex& voxel) {
        const double at_m = along.dot(grid.Centre(voxel) - scan.X_WS.p);
        const double sdf_m = returned ? std::min(surface_m - at_m, truncation_m) : truncation_m;
        if (sdf_m <= -truncation_m) return true;
        TsdfBlock& block = map_.Allocate(grid.Block(voxel));
        const int i = TsdfBlock::IndexOf(voxel);
        const double added = (1 + std::min(sdf_m / truncation_m, 0.0)) / (surface_m * surface_m);
        const double sum = block.weight[i] + added;
        block.distance_m[i] =
            static_cast<float>((block.distance_m[i] * block.weight[i] + sdf_m * added) / sum);
        block.weight[i] = static_cast<float>(sum);
        return true;
      });
    }
}

}  // namespace citrine::test

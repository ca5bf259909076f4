#include "tests/support/voxel_integrator.h"

#include "fusion/scan_view.h"

namespace citrine::test {

using fusion::EightCubes;

std::vector<int> VoxelIntegrator::Integrate(const LidarScan& scan) {
  const VoxelGrid& grid = map_.grid();
  image_.Take(scan, grid.voxel_m());
  bounds_.Take(image_, map_.truncation_m());
  const fusion::ScanView view(scan, map_, image_, bounds_);
  std::vector<int> changed;
  for (int block = 0; block < grid.num_blocks(); ++block) {
    bool news = false;
    const EightCubes octants = view.CubesFrom(view.InSensor(grid.Centre(grid.BlockOrigin(block))), 2);
    for (int octant = 0; octant < 8; ++octant) {
      const EightCubes bricks = view.CubesFrom(octants.Lowest(octant), 1);
      for (int brick = 0; brick < 8; ++brick) {
        const fusion::Points at = view.VoxelsFrom(bricks.Lowest(brick));
        const fusion::Observation told = view.observer().Observe(view.observer().LookAt(at.x, at.y, at.z));
        if (told.said.any()) news |= fuser_.Fuse(told, 8 * octant + brick, map_.Allocate(block));
      }
    }
    if (news) changed.push_back(block);
  }
  return changed;
}

}  // namespace citrine::test

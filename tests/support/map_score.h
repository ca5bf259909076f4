#pragma once

#include <vector>

#include "core/map/tri_mesh.h"
#include "tests/support/house_flight.h"

namespace citrine::test {

/// How a mesh stands to the true surface that was seen.
struct MapScore {
  double error_mean_m = 0, error_p95_m = 0;  ///< from points on the mesh to the true triangles, capped at 1 m
  double seen_pct = 0;  ///< of the surface truly seen, the share within sqrt(3)/2 voxel of the mesh
  double area_m2 = 0;   ///< of the mesh
};

/// Points that noise-free beams of the scans hit: one for each cell of 8 cm.
std::vector<Eigen::Vector3f> SeenSurface(const std::vector<LidarScan>& noise_free);

/// Both distances are to triangles, exact.
MapScore Score(const TriMesh& mesh, const sim::RayScene& truth, const std::vector<Eigen::Vector3f>& seen_W,
               double voxel_m);

}  // namespace citrine::test

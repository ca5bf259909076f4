#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/map/tri_mesh.h"

namespace citrine::logs {

/// [m^2] of all triangles.
double Area(const TriMesh& mesh);

/// [m] round(area x samples_per_m2) points on a mesh, uniform by area, in order of triangle; at least one if
/// there is any area. The area is cut into as many equal strata and one point drawn in each, so that counts
/// per region hardly vary; the same seed gives the same points.
std::vector<Eigen::Vector3f> SampleSurface(const TriMesh& mesh, double samples_per_m2, std::uint64_t seed);

}  // namespace citrine::logs

#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace citrine {

/// Triangles with shared vertices, counter-clockwise seen from outside.
struct TriMesh {
  std::vector<Eigen::Vector3f> vertices_W;  ///< [m]
  std::vector<std::array<int, 3>> triangles;
  std::vector<float> confidence;  ///< one a vertex, or empty
};

}  // namespace citrine

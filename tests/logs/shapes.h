#pragma once

#include <cmath>

#include "core/map/tri_mesh.h"

namespace citrine::logs {

/// Faces of an axis-aligned box, two triangles each.
inline TriMesh Box(const Eigen::Vector3f& min, const Eigen::Vector3f& max) {
  TriMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices_W.emplace_back(i & 1 ? max.x() : min.x(), i & 2 ? max.y() : min.y(),
                                 i & 4 ? max.z() : min.z());
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// A sphere of `rings` x 2 `rings` quads.
inline TriMesh Sphere(float radius, int rings) {
  TriMesh mesh;
  const int columns = 2 * rings;
  for (int r = 0; r <= rings; ++r)
    for (int c = 0; c < columns; ++c) {
      const double polar = EIGEN_PI * r / rings, azimuth = 2 * EIGEN_PI * c / columns;
      mesh.vertices_W.push_back(radius * Eigen::Vector3d(std::sin(polar) * std::cos(azimuth),
                                                         std::sin(polar) * std::sin(azimuth), std::cos(polar))
                                             .cast<float>());
    }
  for (int r = 0; r < rings; ++r)
    for (int c = 0; c < columns; ++c) {
      const int a = r * columns + c, b = r * columns + (c + 1) % columns;
      mesh.triangles.push_back({a, a + columns, b});
      mesh.triangles.push_back({b, a + columns, b + columns});
    }
  return mesh;
}

inline TriMesh Shifted(TriMesh mesh, const Eigen::Vector3f& by) {
  for (Eigen::Vector3f& v : mesh.vertices_W) v += by;
  return mesh;
}

}  // namespace citrine::logs

#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "core/map/tri_mesh.h"

namespace citrine::logs {

inline double SegmentDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d ab = b - a;
  const double length2 = ab.squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return (a + t * ab - p).norm();
}

/// [m] from a point to the nearest point of a triangle, exact.
inline double TriangleDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                               const Eigen::Vector3d& c) {
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double area2 = normal.norm();
  if (area2 > 0) {
    const bool above = normal.dot((b - a).cross(p - a)) >= 0 && normal.dot((c - b).cross(p - b)) >= 0 &&
                       normal.dot((a - c).cross(p - c)) >= 0;
    if (above) return std::abs(normal.dot(p - a)) / area2;
  }
  return std::min({SegmentDistance(p, a, b), SegmentDistance(p, b, c), SegmentDistance(p, c, a)});
}

/// [m] from a point to a mesh, triangle by triangle.
inline double MeshDistance(const TriMesh& mesh, const Eigen::Vector3d& p) {
  double least = 1e30;
  for (const auto& t : mesh.triangles)
    least = std::min(
        least, TriangleDistance(p, mesh.vertices_W[t[0]].cast<double>(), mesh.vertices_W[t[1]].cast<double>(),
                                mesh.vertices_W[t[2]].cast<double>()));
  return least;
}

}  // namespace citrine::logs

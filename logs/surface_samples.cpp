#include "logs/surface_samples.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "core/random.h"

namespace citrine::logs {
namespace {

double TriangleArea(const TriMesh& mesh, const std::array<int, 3>& t) {
  const Eigen::Vector3d a = mesh.vertices_W[t[0]].cast<double>();
  const Eigen::Vector3d b = mesh.vertices_W[t[1]].cast<double>();
  const Eigen::Vector3d c = mesh.vertices_W[t[2]].cast<double>();
  return 0.5 * (b - a).cross(c - a).norm();
}

/// Uniform in the triangle: the square folded along its diagonal.
Eigen::Vector3f PointIn(const TriMesh& mesh, const std::array<int, 3>& t, Random& random) {
  double u = random.Uniform(), v = random.Uniform();
  if (u + v > 1) u = 1 - u, v = 1 - v;
  const Eigen::Vector3d a = mesh.vertices_W[t[0]].cast<double>();
  const Eigen::Vector3d b = mesh.vertices_W[t[1]].cast<double>();
  const Eigen::Vector3d c = mesh.vertices_W[t[2]].cast<double>();
  return (a + u * (b - a) + v * (c - a)).cast<float>();
}

}  // namespace

double Area(const TriMesh& mesh) {
  double area = 0;
  for (const auto& triangle : mesh.triangles) area += TriangleArea(mesh, triangle);
  return area;
}

std::vector<Eigen::Vector3f> SampleSurface(const TriMesh& mesh, double samples_per_m2, std::uint64_t seed) {
  std::vector<Eigen::Vector3f> points_W;
  const double area = Area(mesh);
  if (!(area > 0)) return points_W;
  const auto count = static_cast<std::size_t>(std::max(1.0, std::round(area * samples_per_m2)));
  points_W.reserve(count);

  Random random(seed);
  const double stratum = area / static_cast<double>(count);
  double area_before = 0;
  double next = random.Uniform() * stratum;
  for (const auto& triangle : mesh.triangles) {
    area_before += TriangleArea(mesh, triangle);
    while (next < area_before && points_W.size() < count) {
      points_W.push_back(PointIn(mesh, triangle, random));
      next = (static_cast<double>(points_W.size()) + random.Uniform()) * stratum;
    }
  }
  return points_W;
}

}  // namespace citrine::logs

#include "sim/world/primitives.h"

#include <algorithm>
#include <cmath>

namespace citrine::sim {
namespace {

/// A point of a profile that is turned about z: distance from the axis and height.
struct ProfilePoint {
  double radius = 0, z = 0;
};

/// Even number of facets around a full circle that keeps the sagitta.
int FacetsAround(double radius_m) {
  const double half_angle = std::acos(std::max(0.0, 1 - kSagitta_m / std::max(radius_m, kSagitta_m)));
  return 2 * std::max(6, static_cast<int>(std::ceil(EIGEN_PI / half_angle / 2)));
}

/// Turns a profile, given from the top to the bottom and beginning and ending on the axis, into a closed
/// mesh.
TriMesh Turn(const std::vector<ProfilePoint>& profile, int facets) {
  TriMesh mesh;
  const int rings = static_cast<int>(profile.size()) - 2;
  mesh.vertices_W.emplace_back(0.0f, 0.0f, static_cast<float>(profile.front().z));
  for (int ring = 1; ring <= rings; ++ring)
    for (int i = 0; i < facets; ++i) {
      const double angle = 2 * EIGEN_PI * i / facets;
      mesh.vertices_W.push_back(Eigen::Vector3d(profile[ring].radius * std::cos(angle),
                                                profile[ring].radius * std::sin(angle), profile[ring].z)
                                    .cast<float>());
    }
  mesh.vertices_W.emplace_back(0.0f, 0.0f, static_cast<float>(profile.back().z));
  const int bottom = static_cast<int>(mesh.vertices_W.size()) - 1;
  const auto vertex = [&](int ring, int i) { return 1 + ring * facets + i % facets; };
  for (int i = 0; i < facets; ++i) {
    mesh.triangles.push_back({0, vertex(0, i), vertex(0, i + 1)});
    for (int ring = 0; ring + 1 < rings; ++ring) {
      mesh.triangles.push_back({vertex(ring, i), vertex(ring + 1, i), vertex(ring + 1, i + 1)});
      mesh.triangles.push_back({vertex(ring, i), vertex(ring + 1, i + 1), vertex(ring, i + 1)});
    }
    mesh.triangles.push_back({bottom, vertex(rings - 1, i + 1), vertex(rings - 1, i)});
  }
  return mesh;
}

/// Half circle from the top to the bottom, drawn apart by `straight_m` at the equator.
std::vector<ProfilePoint> HalfCircle(double radius_m, int facets, double straight_m) {
  std::vector<ProfilePoint> profile;
  for (int i = 0; i <= facets; ++i) {
    const double polar = EIGEN_PI * i / facets;
    const double radius = i == 0 || i == facets ? 0 : radius_m * std::sin(polar);
    const double z = radius_m * std::cos(polar);
    if (2 * i <= facets) profile.push_back({radius, z + straight_m / 2});
    if (2 * i >= facets && (straight_m > 0 || 2 * i != facets))
      profile.push_back({radius, z - straight_m / 2});
  }
  return profile;
}

}  // namespace

TriMesh BoxMesh(const Eigen::Vector3d& size_m) {
  TriMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices_W.push_back(Eigen::Vector3d((i & 1 ? 0.5 : -0.5) * size_m.x(),
                                              (i & 2 ? 0.5 : -0.5) * size_m.y(),
                                              (i & 4 ? 0.5 : -0.5) * size_m.z())
                                  .cast<float>());
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriMesh CylinderMesh(double radius_m, double length_m) {
  return Turn({{0, length_m / 2}, {radius_m, length_m / 2}, {radius_m, -length_m / 2}, {0, -length_m / 2}},
              FacetsAround(radius_m));
}

TriMesh CapsuleMesh(double radius_m, double length_m) {
  const int facets = FacetsAround(radius_m);
  return Turn(HalfCircle(radius_m, facets / 2 + facets / 2 % 2, length_m), facets);
}

TriMesh EllipsoidMesh(const Eigen::Vector3d& radii_m) {
  const int facets = FacetsAround(radii_m.maxCoeff());
  TriMesh mesh = Turn(HalfCircle(1.0, facets / 2 + facets / 2 % 2, 0), facets);
  for (Eigen::Vector3f& v : mesh.vertices_W) v = v.cwiseProduct(radii_m.cast<float>());
  return mesh;
}

TriMesh SheetMesh(const Eigen::Vector2d& min_m, const Eigen::Vector2d& max_m) {
  TriMesh mesh;
  for (int i = 0; i < 4; ++i)
    mesh.vertices_W.push_back(
        Eigen::Vector3d(i & 1 ? max_m.x() : min_m.x(), i & 2 ? max_m.y() : min_m.y(), 0).cast<float>());
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}};
  return mesh;
}

}  // namespace citrine::sim

#include "sim/world/true_surface.h"

#include <cmath>

#include "core/random.h"

namespace citrine::sim {
namespace {

constexpr double kProbe_m = 0.02;  ///< solid is looked for this far off the surface

using Polygon = std::vector<Eigen::Vector3d>;

/// Cuts a convex polygon along one face of a box (Sutherland & Hodgman 1974). @param side +1 keeps what is
/// below `limit`
Polygon Clip(const Polygon& polygon, int axis, double limit, double side) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector3d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = side * (limit - a[axis]), db = side * (limit - b[axis]);
    if (da >= 0) kept.push_back(a);
    if (da * db < 0) kept.push_back(a + da / (da - db) * (b - a));
  }
  return kept;
}

Polygon Clip(Polygon polygon, const Eigen::AlignedBox3d& box) {
  for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
    polygon = Clip(polygon, axis, box.max()[axis], 1);
    if (!polygon.empty()) polygon = Clip(polygon, axis, box.min()[axis], -1);
  }
  return polygon;
}

/// Uniform in a triangle (Osada et al. 2002).
Eigen::Vector3d PointIn(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                        Random& random) {
  const double r = std::sqrt(random.Uniform()), s = random.Uniform();
  return (1 - r) * a + r * (1 - s) * b + r * s * c;
}

}  // namespace

TrueSurface SampleTrueSurface(const World& world, const RayScene& scene, const Eigen::AlignedBox3d& volume_W,
                              double density_per_m2, std::uint64_t seed) {
  // Float vertices lie a little off the faces of the volume; what is meant to lie on them belongs to it.
  const Eigen::Vector3d slack = Eigen::Vector3d::Constant(1e-4);
  const Eigen::AlignedBox3d box(volume_W.min() - slack, volume_W.max() + slack);
  Random random(seed);
  TrueSurface surface;
  const double piece_m2 = 1 / density_per_m2;
  double due_m2 = piece_m2 * random.Uniform(), drawn = 0;
  for (const Part& part : world.parts)
    for (int t = part.first_triangle; t < part.first_triangle + part.num_triangles; ++t) {
      Polygon polygon;
      for (const int corner : world.mesh.triangles[t])
        polygon.push_back(world.mesh.vertices_W[corner].cast<double>());
      const Eigen::Vector3d normal = (polygon[1] - polygon[0]).cross(polygon[2] - polygon[0]).normalized();
      polygon = Clip(std::move(polygon), box);
      for (std::size_t i = 2; i < polygon.size(); ++i) {
        due_m2 -= 0.5 * (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]).norm();
        for (; due_m2 < 0; due_m2 += piece_m2, ++drawn) {
          const Eigen::Vector3d p_W = PointIn(polygon[0], polygon[i - 1], polygon[i], random);
          const bool solid_outside = scene.Solid(p_W + kProbe_m * normal);
          if (solid_outside && scene.Solid(p_W - kProbe_m * normal)) continue;
          const Eigen::Vector3d n_W = solid_outside ? Eigen::Vector3d(-normal) : normal;
          surface.samples.push_back(
              {p_W.cast<float>(), n_W.cast<float>(), static_cast<float>(piece_m2), part.ground});
        }
      }
    }
  surface.area_m2 = piece_m2 * static_cast<double>(surface.samples.size());
  surface.dropped_share = drawn > 0 ? 1 - static_cast<double>(surface.samples.size()) / drawn : 0;
  return surface;
}

}  // namespace citrine::sim

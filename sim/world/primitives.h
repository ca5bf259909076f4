#pragma once

#include <Eigen/Core>

#include "core/map/tri_mesh.h"

namespace citrine::sim {

/// [m] what a round shape's facets may lie inside of the true surface, at most
inline constexpr double kSagitta_m = 0.01;

// Closed shapes about the origin of their own frame, as SDFormat means them; outward, counter-clockwise
// triangles.
TriMesh BoxMesh(const Eigen::Vector3d& size_m);
TriMesh CylinderMesh(double radius_m, double length_m);  ///< along z, flat ends
TriMesh CapsuleMesh(double radius_m, double length_m);   ///< along z, length without the half spheres
TriMesh EllipsoidMesh(const Eigen::Vector3d& radii_m);

/// A rectangle in its own x-y plane, seen from +z.
TriMesh SheetMesh(const Eigen::Vector2d& min_m, const Eigen::Vector2d& max_m);

}  // namespace citrine::sim

#pragma once

#include <string>

#include <Eigen/Geometry>

#include "sim/world/world.h"

namespace citrine::sim {

/// Adds a mesh to a world as a new part. Triangles without area are dropped; a mesh of nothing else adds no
/// part.
/// @param X_WM  places the mesh's vertices in the world, scale included
/// @throws WorldError if a vertex is not finite
void AddPart(const TriMesh& mesh_M, const Eigen::Affine3d& X_WM, const Part& part, World& world);

/// Fills in bounds and hash. @throws WorldError if there is no surface
void Finish(const std::string& path, World& world);

}  // namespace citrine::sim

#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/map/tri_mesh.h"

namespace citrine::sim {

/// One mesh of a mesh file, in metres, z up.
struct NamedMesh {
  std::string name;                ///< of the mesh; may be empty
  std::vector<std::string> nodes;  ///< names of the nodes above it, from the root
  TriMesh mesh;
};

/// Reads a mesh file. A COLLADA file's unit and up axis are obeyed, glTF is y up; any other file is taken as
/// it is.
/// @throws WorldError
std::vector<NamedMesh> ReadMeshFile(const std::string& path);

}  // namespace citrine::sim

#pragma once

#include <string>

#include "core/map/tri_mesh.h"

namespace citrine {

/// Binary little-endian PLY: float x, y, z (and confidence) a vertex, a list of three ints a face.
/// @throws std::runtime_error naming the file if it cannot be written
void WritePly(const std::string& path, const TriMesh& mesh);

/// Reads what WritePly writes. @throws std::runtime_error naming the file, what is wrong, and where
TriMesh ReadPly(const std::string& path);

}  // namespace citrine

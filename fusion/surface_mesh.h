#pragma once

#include "core/map/tri_mesh.h"
#include "core/map/tsdf_map.h"

namespace citrine::fusion {

/// The surface of a map inside the mission volume by marching cubes, its vertices shared and their confidence
/// the voxels' quality.
///
/// A cell takes part if it meets the volume, all its eight voxels are known, and the distance does not jump
/// between two of them by more than a surface can make it: the back of what was seen from one side only is no
/// surface.
TriMesh SurfaceMesh(const TsdfMap& map);

}  // namespace citrine::fusion

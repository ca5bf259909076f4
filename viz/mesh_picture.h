#pragma once

#include "core/map/tri_mesh.h"
#include "viz/image.h"

namespace citrine::viz {

/// Where a mesh is looked at from: a parallel projection that fills the picture.
struct MeshView {
  double azimuth_rad = -2.1;  ///< of the viewer, seen from the mesh
  double elevation_rad = 0.6;
  int width = 1600, height = 1000;
  float weight_goal = 0;  ///< w*: poor vertices are drawn blue, those at the goal warm; 0: all plain
};

/// A shaded, z-buffered picture of a mesh. Faces that turn their back to the viewer are dark, so that holes
/// and surface that is inside out are seen at a glance.
Image DrawMesh(const TriMesh& mesh, const MeshView& view);

}  // namespace citrine::viz
